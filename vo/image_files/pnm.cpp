#include "vo/image_files/pnm.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "vo/core/error.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

constexpr int kGreatestByte = 255;
constexpr int kGreatest = 65535;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/// Returns the next number of a header at `at`, which moves behind it; blanks and comments (from
/// '#' to the end of the line) come before it.
int next_number(std::string_view bytes, std::size_t& at, const std::filesystem::path& path) {
  while (at < bytes.size() && (is_blank(bytes[at]) || bytes[at] == '#')) {
    at = bytes[at] == '#' ? std::min(bytes.find('\n', at), bytes.size()) : at + 1;
  }
  int number = 0;
  const auto [end, error] = std::from_chars(bytes.data() + at, bytes.data() + bytes.size(), number);
  require(error == std::errc() && number >= 0, path.string(),
          ": expected width, height and greatest value in the map's header");
  at = static_cast<std::size_t>(end - bytes.data());
  return number;
}

/// A map's header.
struct PnmHeader {
  bool is_color = false;
  cv::Size size;
  int greatest = 0;
  std::size_t pixels = 0;  ///< index of the first pixel's byte
};

PnmHeader read_header_of(std::string_view bytes, const std::filesystem::path& path) {
  PnmHeader header{.is_color = bytes[1] == '6'};
  std::size_t at = 2;
  header.size.width = next_number(bytes, at, path);
  header.size.height = next_number(bytes, at, path);
  header.greatest = next_number(bytes, at, path);
  const int limit = header.is_color ? kGreatestByte : kGreatest;
  require(header.greatest > 0 && header.greatest <= limit, path.string(),
          ": expected a greatest value from 1 to ", limit, ", got ", header.greatest);
  require(at < bytes.size() && is_blank(bytes[at]), path.string(),
          ": expected a blank behind the map's header");
  header.pixels = at + 1;
  return header;
}

void read_byte_row(const std::uint8_t* from, const PnmHeader& header, cv::Mat& image, int v) {
  const int values = image.cols * image.channels();
  auto* to = image.ptr<std::uint8_t>(v);
  for (int i = 0; i < values; ++i) {
    const int value = std::min<int>(from[i], header.greatest);
    const int target = header.is_color ? i + 2 - 2 * (i % 3) : i;  // from RGB to BGR
    to[target] =
        static_cast<std::uint8_t>((value * kGreatestByte + header.greatest / 2) / header.greatest);
  }
}

void read_wide_row(const std::uint8_t* from, cv::Mat& image, int v) {
  auto* to = image.ptr<std::uint16_t>(v);
  for (int u = 0; u < image.cols; ++u) {
    to[u] = static_cast<std::uint16_t>(from[2 * u] << 8 | from[2 * u + 1]);
  }
}

}  // namespace

bool is_pnm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '5' || bytes[1] == '6') &&
         is_blank(bytes[2]);
}

cv::Mat decode_pnm(std::string_view bytes, const std::filesystem::path& path) {
  require(is_pnm(bytes), path.string(), ": is no binary portable map (P5 or P6)");
  const PnmHeader header = read_header_of(bytes, path);
  const bool is_wide = header.greatest > kGreatestByte;
  const int type = header.is_color ? CV_8UC3 : is_wide ? CV_16UC1 : CV_8UC1;
  const std::size_t row = static_cast<std::size_t>(header.size.width) * CV_ELEM_SIZE(type);
  const std::size_t expected = header.pixels + row * static_cast<std::size_t>(header.size.height);
  require(bytes.size() >= expected, path.string(), ": expected ", expected, " bytes for ",
          header.size.width, "x", header.size.height, " px, got ", bytes.size());
  cv::Mat image = new_image(header.size, type, path);
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data()) + header.pixels;
  for (int v = 0; v < image.rows; ++v, from += row) {
    if (is_wide) {
      read_wide_row(from, image, v);
    } else {
      read_byte_row(from, header, image, v);
    }
  }
  return image;
}

std::string encode_pnm(const cv::Mat& image) {
  const bool is_color = image.type() == CV_8UC3;
  const bool is_wide = image.type() == CV_16UC1;
  std::string bytes = concat(is_color ? "P6" : "P5", "\n", image.cols, " ", image.rows, "\n",
                             is_wide ? kGreatest : kGreatestByte, "\n");
  const int row_bytes = image.cols * static_cast<int>(image.elemSize());
  for (int v = 0; v < image.rows; ++v) {
    const auto* row = image.ptr<std::uint8_t>(v);
    for (int i = 0; i < row_bytes; ++i) {
      const int source = is_color  ? i + 2 - 2 * (i % 3)
                         : is_wide ? i ^ 1
                                   : i;  // BGR; high byte last
      bytes.push_back(static_cast<char>(row[source]));
    }
  }
  return bytes;
}

}  // namespace vo
