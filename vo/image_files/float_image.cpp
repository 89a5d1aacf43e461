#include "vo/image_files/float_image.h"

#include "vo/core/error.h"
#include "vo/image_files/float_tiff.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/pfm.h"

namespace vo {

std::string encode_float_image(const cv::Mat& image, FloatFormat format) {
  switch (format) {
    case FloatFormat::npy:
      return encode_npy(image);
    case FloatFormat::pfm:
      return encode_pfm(image);
    case FloatFormat::tiff:
      return encode_float_tiff(image);
  }
  return "";
}

cv::Mat read_float_image(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".npy") {
    return read_npy(path);
  }
  if (extension == ".pfm") {
    return read_pfm(path);
  }
  require(extension == ".tiff" || extension == ".tif", path.string(),
          ": expected a float image, .npy, .pfm or .tiff");
  return read_float_tiff(path);
}

}  // namespace vo
