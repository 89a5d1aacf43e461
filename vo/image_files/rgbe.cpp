#include "vo/image_files/rgbe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/image_files/new_image.h"

namespace vo {
namespace {

constexpr int kBias = 128;  // of the exponent
constexpr int kMantissaBits = 8;
constexpr double kBrightest = 1e30;    // of a channel; what is brighter is taken as this
constexpr int kShortestPacked = 8;     // px, rows from this length
constexpr int kLongestPacked = 32767;  // to this one may be packed channel by channel

using Rgbe = std::array<std::uint8_t, 4>;

/// The bytes of a file that are not read yet.
class Reader {
 public:
  Reader(std::string_view bytes, const std::filesystem::path& path) : left_(bytes), path_(path) {}

  /// Returns the next line without its end.
  std::string_view line() {
    const std::size_t end = left_.find('\n');
    require(end != std::string_view::npos, path_.string(), ": ends within its header");
    const std::string_view result = left_.substr(0, end);
    left_.remove_prefix(end + 1);
    return result;
  }

  std::uint8_t byte() {
    require(!left_.empty(), path_.string(), ": ends before its last pixel");
    const auto result = static_cast<std::uint8_t>(left_.front());
    left_.remove_prefix(1);
    return result;
  }

  Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }

 private:
  std::string_view left_;
  const std::filesystem::path& path_;
};

struct Header {
  cv::Size size;
  double exposure = 1;  ///< pixels are this times the light
};

/// Reads lines up to the empty one, and the line of the size.
Header read_header(Reader& reader, const std::filesystem::path& path) {
  Header header;
  for (std::string line(reader.line()); !line.empty(); line = reader.line()) {
    if (line.starts_with("EXPOSURE=")) {
      header.exposure *= std::strtod(line.c_str() + line.find('=') + 1, nullptr);
    }
    require(!line.starts_with("FORMAT=") || line == "FORMAT=32-bit_rle_rgbe", path.string(),
            ": is of ", line, ", expected 32-bit_rle_rgbe");
  }
  require(std::isfinite(header.exposure) && header.exposure > 0, path.string(),
          ": its EXPOSURE is ", header.exposure, ", expected a positive number");
  const std::string line(reader.line());
  const int values =
      std::sscanf(line.c_str(), "-Y %d +X %d", &header.size.height, &header.size.width);
  require(values == 2, path.string(), ": has a size of \"", line,
          "\", expected -Y HEIGHT +X WIDTH");
  return header;
}

/// Reads one channel of a packed row: runs of one value, 128 + length, and literal bytes.
void read_channel(Reader& reader, std::size_t channel, std::vector<Rgbe>& row,
                  const std::filesystem::path& path) {
  constexpr int kRun = 128;
  for (std::size_t u = 0; u < row.size();) {
    const int code = reader.byte();
    const auto length = static_cast<std::size_t>(code > kRun ? code - kRun : code);
    require(length > 0 && u + length <= row.size(), path.string(),
            ": has a run beyond the end of a row");
    const std::uint8_t value = reader.byte();
    for (std::size_t i = 0; i < length; ++i) {
      row[u++][channel] = code > kRun || i == 0 ? value : reader.byte();
    }
  }
}

/// Reads the rest of a row that is not packed channel by channel: pixels, and runs of the last one,
/// whose lengths are the digits of a number to the base 256.
void read_pixels(Reader& reader, const Rgbe& first, std::vector<Rgbe>& row,
                 const std::filesystem::path& path) {
  std::size_t u = 0;
  unsigned shift = 0;
  for (Rgbe pixel = first;; pixel = reader.pixel()) {
    const bool is_run = pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1;
    const std::size_t length = is_run ? static_cast<std::size_t>(pixel[3]) << shift : 1;
    require(u + length <= row.size() && (!is_run || (u > 0 && shift <= 16)), path.string(),
            ": has a run beyond the end of a row");
    std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(u), length, is_run ? row[u - 1] : pixel);
    shift = is_run ? shift + 8 : 0;
    u += length;
    if (u == row.size()) {
      return;
    }
  }
}

void read_row(Reader& reader, std::vector<Rgbe>& row, const std::filesystem::path& path) {
  const auto width = static_cast<int>(row.size());
  const Rgbe first = reader.pixel();
  const bool may_be_packed = width >= kShortestPacked && width <= kLongestPacked;
  if (may_be_packed && first[0] == 2 && first[1] == 2 && first[2] * 256 + first[3] == width) {
    for (std::size_t channel = 0; channel < first.size(); ++channel) {
      read_channel(reader, channel, row, path);
    }
  } else {
    read_pixels(reader, first, row, path);
  }
}

cv::Vec3f light_of(const Rgbe& pixel, double exposure) {
  if (pixel[3] == 0) {
    return {0, 0, 0};
  }
  const double scale = std::ldexp(1 / exposure, pixel[3] - kBias - kMantissaBits);
  const auto channel = [&](std::size_t i) {
    return static_cast<float>(std::min(pixel.at(i) * scale, kBrightest));
  };
  return {channel(0), channel(1), channel(2)};
}

Rgbe rgbe_of(const cv::Vec3f& light) {
  const float largest = std::max({light[0], light[1], light[2]});
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (!(largest > 0) || exponent + kBias <= 0) {
    return {0, 0, 0, 0};
  }
  const auto mantissa = [&](float value) {
    const float scaled = std::ldexp(value, kMantissaBits - exponent);
    return static_cast<std::uint8_t>(std::clamp(scaled, 0.0F, 255.0F));
  };
  return {mantissa(light[0]), mantissa(light[1]), mantissa(light[2]),
          static_cast<std::uint8_t>(std::min(255, exponent + kBias))};
}

}  // namespace

cv::Mat_<cv::Vec3f> read_rgbe(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  require(bytes.starts_with("#?"), path.string(),
          ": expected an image of linear light in Radiance's format (.hdr)");
  Reader reader(bytes, path);
  const Header header = read_header(reader, path);
  cv::Mat_<cv::Vec3f> image = new_light_image(header.size, path);
  std::vector<Rgbe> row(static_cast<std::size_t>(image.cols));
  for (int v = 0; v < image.rows; ++v) {
    read_row(reader, row, path);
    std::transform(row.begin(), row.end(), image[v],
                   [&](const Rgbe& pixel) { return light_of(pixel, header.exposure); });
  }
  return image;
}

std::string encode_rgbe(const cv::Mat_<cv::Vec3f>& image) {
  std::string bytes =
      concat("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ", image.rows, " +X ", image.cols, "\n");
  for (const cv::Vec3f& light : image) {
    const Rgbe pixel = rgbe_of(light);
    bytes.append(pixel.begin(), pixel.end());
  }
  return bytes;
}

}  // namespace vo
