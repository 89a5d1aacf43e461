#include "vo/image_files/image_file.h"

#include <string>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/png.h"
#include "vo/image_files/pnm.h"

namespace vo {

cv::Mat read_image(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  if (is_png(bytes)) {
    return decode_png(bytes, path);
  }
  if (is_jpeg(bytes)) {
    return decode_jpeg(bytes, path);
  }
  require(is_pnm(bytes), path.string(),
          ": is no image that is read, expected PNG, JPEG, PGM or PPM");
  return decode_pnm(bytes, path);
}

}  // namespace vo
