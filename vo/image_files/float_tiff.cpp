#include "vo/image_files/float_tiff.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

// The layout (TIFF 6.0): header, pixels, bits and formats of three samples, one directory.
constexpr std::uint32_t kPixelsAt = 8;  // bytes from the start, just after the header
constexpr std::uint32_t kFloat = 3;     // SampleFormat: IEEE floating point
constexpr std::uint32_t kBlackIsZero = 1;
constexpr std::uint32_t kRgb = 2;

enum class FieldKind : std::uint16_t { two_bytes = 3, four_bytes = 4 };

class Bytes {
 public:
  void add(std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i, value >>= 8U) {
      bytes_.push_back(static_cast<char>(value & 0xffU));
    }
  }

  void add_field(std::uint32_t tag, FieldKind kind, std::uint32_t count, std::uint32_t value) {
    add(tag, 2);
    add(static_cast<std::uint32_t>(kind), 2);
    add(count, 4);
    add(value, 4);
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Returns the bytes of the two triples of 16-bit values, bits and formats, that do not fit into
/// the fields of a colour image.
std::uint32_t size_of_triples(std::uint32_t channels) {
  return channels == 1 ? 0 : 12;
}

std::string directory(const cv::Mat& image, std::uint32_t pixel_bytes) {
  const auto channels = static_cast<std::uint32_t>(image.channels());
  const std::uint32_t triples_at = kPixelsAt + pixel_bytes;
  const auto short_field = FieldKind::two_bytes;
  const auto long_field = FieldKind::four_bytes;
  Bytes bytes;
  for (const std::uint32_t value : {32U, kFloat}) {
    for (std::uint32_t i = 0; channels > 1 && i < channels; ++i) {
      bytes.add(value, 2);
    }
  }
  bytes.add(11, 2);  // number of fields, which follow by increasing tag
  bytes.add_field(256, long_field, 1, static_cast<std::uint32_t>(image.cols));
  bytes.add_field(257, long_field, 1, static_cast<std::uint32_t>(image.rows));
  bytes.add_field(258, short_field, channels, channels == 1 ? 32 : triples_at);
  bytes.add_field(259, short_field, 1, 1);  // not compressed
  bytes.add_field(262, short_field, 1, channels == 1 ? kBlackIsZero : kRgb);
  bytes.add_field(273, long_field, 1, kPixelsAt);
  bytes.add_field(277, short_field, 1, channels);
  bytes.add_field(278, long_field, 1, static_cast<std::uint32_t>(image.rows));
  bytes.add_field(279, long_field, 1, pixel_bytes);
  bytes.add_field(284, short_field, 1, 1);  // the channels of a pixel lie together
  bytes.add_field(339, short_field, channels, channels == 1 ? kFloat : triples_at + 6);
  bytes.add(0, 4);  // no further directory
  return bytes.take();
}

std::uint32_t number_at(const std::string& bytes, std::size_t position, int size) {
  std::uint32_t value = 0;
  for (int i = size; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[position + static_cast<std::size_t>(i)]);
  }
  return value;
}

}  // namespace

std::string encode_float_tiff(const cv::Mat& image) {
  CV_Assert(image.depth() == CV_32F && (image.channels() == 1 || image.channels() == 3));
  const std::size_t row = static_cast<std::size_t>(image.cols) * image.elemSize();
  const auto pixel_bytes = static_cast<std::uint32_t>(row * static_cast<std::size_t>(image.rows));
  Bytes header;
  header.add('I' | 'I' << 8, 2);
  header.add(42, 2);
  header.add(
      kPixelsAt + pixel_bytes + size_of_triples(static_cast<std::uint32_t>(image.channels())), 4);
  std::string bytes = header.take();
  for (int v = 0; v < image.rows; ++v) {
    bytes.append(image.ptr<char>(v), row);
  }
  return bytes + directory(image, pixel_bytes);
}

/// The size and the number of channels come from the directory; all else must be equal to what
/// `encode_float_tiff` writes.
cv::Mat read_float_tiff(const std::filesystem::path& path) {
  constexpr std::uint32_t kMostUseful = 1 << 30;  // px, so that sizes can be computed with
  constexpr std::size_t kDirectoryBytes = 2 + 11 * 12 + 4;
  const std::string bytes = read_file(path);
  const auto expect = [&](bool condition) {
    require(condition, path.string(), ": expected a little-endian TIFF of one strip of 32-bit ",
            "floats in one or three channels, not compressed");
  };
  expect(bytes.size() > kPixelsAt && bytes.starts_with(std::string_view("II*\0", 4)));
  const std::size_t fields = number_at(bytes, 4, 4);
  expect(fields >= kPixelsAt && fields + kDirectoryBytes == bytes.size() &&
         number_at(bytes, fields, 2) == 11);
  const auto field = [&](std::size_t i) { return number_at(bytes, fields + 2 + 12 * i + 8, 4); };
  const std::uint32_t cols = field(0);
  const std::uint32_t rows = field(1);
  const std::uint32_t channels = field(6);
  expect(cols > 0 && rows > 0 && cols <= kMostUseful && rows <= kMostUseful &&
         (channels == 1 || channels == 3));
  const std::size_t size = std::size_t{cols} * rows * channels * sizeof(float);
  expect(fields == kPixelsAt + size + size_of_triples(channels));
  cv::Mat image = new_image({static_cast<int>(cols), static_cast<int>(rows)},
                            channels == 1 ? CV_32FC1 : CV_32FC3, path);
  expect(directory(image, static_cast<std::uint32_t>(size)) == bytes.substr(kPixelsAt + size));
  std::memcpy(image.data, bytes.data() + kPixelsAt, size);
  return image;
}

}  // namespace vo
