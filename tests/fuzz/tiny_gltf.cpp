// tinygltf, compiled with the fuzzer's instrumentation, takes the place of the shared library's.
// Images are not decoded by it.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
