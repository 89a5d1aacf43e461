// OpenEXR's images of linear light.
#include "synth/environment/exr.h"

#include <cmath>

#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::with_file(data, size, "image", [](const std::filesystem::path& path) {
    for (const cv::Vec3f& light : synth::read_exr(path)) {
      for (const int channel : {0, 1, 2}) {
        fuzz::check(std::isfinite(light[channel]) && light[channel] >= 0,
                    "light is finite, 0 or more");
      }
    }
  });
}
