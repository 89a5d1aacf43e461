// JPEG, as textures and the sensor's compression read it, of a size that is known, and as images of
// frames, of any.
#include <span>

#include "tests/fuzz/fuzz_input.h"
#include "vo/image_files/jpeg_codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kWidth = 16;
  constexpr int kHeight = 12;
  try {
    const cv::Mat image = vo::decode_jpeg(std::span(data, size), {kWidth, kHeight});
    fuzz::check(image.size() == cv::Size(kWidth, kHeight),
                "a JPEG has the size that was asked for");
  } catch (const vo::Error&) {
  }
  try {
    vo::decode_jpeg({reinterpret_cast<const char*>(data), size}, "image");
  } catch (const vo::Error&) {
  }
  return 0;
}
