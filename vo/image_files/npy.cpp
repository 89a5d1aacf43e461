#include "vo/image_files/npy.h"

#include <cstdio>
#include <cstring>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

constexpr std::string_view kNpyMagic("\x93NUMPY\x01\x00", 8);
constexpr std::size_t kAlignment = 64;  // bytes, a multiple of which the data starts at

/// Returns all that stands before the data of a file of this type and shape, `3, 4`.
std::string npy_header(const char* type, const std::string& shape) {
  std::string header =
      concat("{'descr': '", type, "', 'fortran_order': False, 'shape': (", shape, "), }");
  const std::size_t used = kNpyMagic.size() + 2 + header.size() + 1;
  header.append((kAlignment - used % kAlignment) % kAlignment, ' ');
  header.push_back('\n');

  std::string bytes(kNpyMagic);
  bytes.push_back(static_cast<char>(header.size() & 0xff));
  bytes.push_back(static_cast<char>(header.size() >> 8));
  return bytes + header;
}

}  // namespace

std::string encode_npy(const cv::Mat& image) {
  CV_Assert(image.depth() == CV_32F && (image.channels() == 1 || image.channels() == 3));
  std::string bytes =
      npy_header("<f4", concat(image.rows, ", ", image.cols, image.channels() == 3 ? ", 3" : ""));
  for (int v = 0; v < image.rows; ++v) {
    bytes.append(image.ptr<char>(v), static_cast<std::size_t>(image.cols) * image.elemSize());
  }
  return bytes;
}

std::string encode_npy(std::span<const double> values, std::span<const std::size_t> shape) {
  std::string lengths;
  for (const std::size_t length : shape) {
    lengths += concat(length, ", ");  // Python's tuple of one has a comma behind it
  }
  return npy_header("<f8", lengths)
      .append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

cv::Mat read_npy(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const std::string expected = concat(path.string(), ": expected a version 1.0 .npy file of '<f4'");
  require(bytes.size() > kNpyMagic.size() + 2 && bytes.starts_with(kNpyMagic), expected);
  const std::size_t header_size =
      static_cast<unsigned char>(bytes[8]) +
      256 * static_cast<std::size_t>(static_cast<unsigned char>(bytes[9]));
  const std::string header = bytes.substr(kNpyMagic.size() + 2, header_size);
  const std::size_t shape = header.find("'shape': (");
  int rows = 0;
  int cols = 0;
  int channels = 1;
  const int values = shape == std::string::npos
                         ? 0
                         : std::sscanf(header.c_str() + shape, "'shape': (%5d, %5d, %1d)", &rows,
                                       &cols, &channels);
  require(header.find("'<f4'") != std::string::npos &&
              header.find("'fortran_order': False") != std::string::npos && values >= 2 &&
              rows > 0 && cols > 0 && (channels == 1 || channels == 3),
          expected, " with two dimensions, or a third of 3");
  const int type = channels == 1 ? CV_32FC1 : CV_32FC3;
  const std::size_t start = kNpyMagic.size() + 2 + header_size;
  const std::size_t size =
      static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols) * CV_ELEM_SIZE(type);
  require(bytes.size() == start + size, path.string(), ": expected ", start + size, " bytes for ",
          cols, "x", rows, " px, got ", bytes.size());
  cv::Mat image = new_image({cols, rows}, type, path);
  std::memcpy(image.data, bytes.data() + start, size);
  return image;
}

}  // namespace vo
