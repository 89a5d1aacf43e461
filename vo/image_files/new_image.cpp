#include "vo/image_files/new_image.h"

#include <cstdint>

#include "vo/core/error.h"

namespace vo {

cv::Mat new_image(cv::Size size, int type, const std::filesystem::path& path) {
  constexpr int kMaxSize = 16384;  // px
  require(size.width > 0 && size.height > 0 && size.width <= kMaxSize && size.height <= kMaxSize,
          path.string(), ": expected an image of 1 to ", kMaxSize, " px in width and height, got ",
          size.width, "x", size.height);
  try {
    return cv::Mat(size, type);
  } catch (const cv::Exception& error) {
    require(error.code == cv::Error::StsNoMem, path.string(), ": ", error.what());
    fail_as(ErrorKind::temporary, path.string(), ": an image of ", size.width, "x", size.height,
            " px needs ", static_cast<double>(size.area()) * CV_ELEM_SIZE(type),
            " bytes of memory, which are not there");
  }
}

cv::Mat_<cv::Vec3f> new_light_image(cv::Size size, const std::filesystem::path& path) {
  constexpr std::int64_t kMostPixels = 1 << 26;
  require(std::int64_t{size.width} * size.height <= kMostPixels, path.string(), ": is ", size.width,
          " x ", size.height, " px, expected at most ", kMostPixels, " pixels");
  return new_image(size, CV_32FC3, path);
}

}  // namespace vo
