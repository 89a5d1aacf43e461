#include "vo/image_files/pfm.h"

#include <cstdio>
#include <cstring>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace vo {

std::string encode_pfm(const cv::Mat& image) {
  CV_Assert(image.depth() == CV_32F && (image.channels() == 1 || image.channels() == 3));
  std::string bytes =
      concat(image.channels() == 1 ? "Pf" : "PF", "\n", image.cols, " ", image.rows, "\n-1.0\n");
  for (int v = image.rows; v-- > 0;) {
    bytes.append(image.ptr<char>(v), static_cast<std::size_t>(image.cols) * image.elemSize());
  }
  return bytes;
}

cv::Mat read_pfm(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  char kind = 0;
  int cols = 0;
  int rows = 0;
  double scale = 0;
  int start = 0;
  const int values =
      std::sscanf(bytes.c_str(), "P%c %d %d %lf%*c%n", &kind, &cols, &rows, &scale, &start);
  require(
      values == 4 && start > 0 && (kind == 'f' || kind == 'F') && scale < 0 && cols > 0 && rows > 0,
      path.string(), ": expected a little-endian portable float map");
  const int type = kind == 'f' ? CV_32FC1 : CV_32FC3;
  const std::size_t row = static_cast<std::size_t>(cols) * CV_ELEM_SIZE(type);
  const std::size_t size = static_cast<std::size_t>(start) + row * static_cast<std::size_t>(rows);
  require(bytes.size() == size, path.string(), ": expected ", size, " bytes, got ", bytes.size());
  cv::Mat image = new_image({cols, rows}, type, path);
  const char* source = bytes.data() + start;
  for (int v = rows; v-- > 0; source += row) {
    std::memcpy(image.ptr(v), source, row);
  }
  return image;
}

}  // namespace vo
