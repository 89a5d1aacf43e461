#include "tools/pictures/webp.h"

#include <cstdint>
#include <memory>

#include <webp/encode.h>

#include "vo/core/error.h"

namespace tools {
namespace {

/// Takes ownership of an encoder's `bytes` and returns them. Throws vo::Error if `size` is 0.
std::string taken(std::uint8_t* bytes, std::size_t size) {
  const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> owned(bytes, &WebPFree);
  vo::require(size > 0, "a picture of the report cannot be encoded as WebP");
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace

std::string encode_webp(const cv::Mat_<cv::Vec3b>& picture, double quality) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size =
      WebPEncodeBGR(picture.ptr(), picture.cols, picture.rows, static_cast<int>(picture.step[0]),
                    static_cast<float>(quality), &bytes);
  return taken(bytes, size);
}

std::string encode_webp_lossless(const cv::Mat_<cv::Vec4b>& picture) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessBGRA(picture.ptr(), picture.cols, picture.rows,
                                                  static_cast<int>(picture.step[0]), &bytes);
  return taken(bytes, size);
}

}  // namespace tools
