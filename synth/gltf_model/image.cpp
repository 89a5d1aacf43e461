#include "synth/gltf_model/image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "vo/core/error.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/png.h"

namespace synth {
namespace {

using vo::require;

constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 26U;  // 8192 x 8192

struct ImageSize {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
};

std::uint64_t read_big_endian(const Bytes& bytes, std::size_t offset, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value = value << 8U | bytes[offset + i];
  }
  return value;
}

bool is_png(const Bytes& bytes) {
  constexpr std::array<std::uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  return bytes.size() >= 24 && std::equal(kSignature.begin(), kSignature.end(), bytes.begin());
}

bool is_jpeg(const Bytes& bytes) {
  return bytes.size() >= 4 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

/// Returns whether a JPEG marker starts a frame: 0xC0 to 0xCF except three markers in this range.
bool is_start_of_frame(std::uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

/// Returns the size in a JPEG's frame header; none if its segments lead to no such header.
std::optional<ImageSize> jpeg_size(const Bytes& bytes) {
  std::size_t position = 2;
  while (position + 9 <= bytes.size() && bytes[position] == 0xFF) {
    const std::uint8_t marker = bytes[position + 1];
    if (marker == 0xFF) {  // fill byte
      ++position;
      continue;
    }
    if (is_start_of_frame(marker)) {
      return ImageSize{read_big_endian(bytes, position + 7, 2),
                       read_big_endian(bytes, position + 5, 2)};
    }
    position += 2 + static_cast<std::size_t>(read_big_endian(bytes, position + 2, 2));
  }
  return std::nullopt;
}

/// Returns the size that an image's header states, so that nothing is allocated for an absurd one.
ImageSize encoded_size(const Bytes& bytes, const std::string& place) {
  if (is_png(bytes)) {
    return {read_big_endian(bytes, 16, 4), read_big_endian(bytes, 20, 4)};
  }
  require(is_jpeg(bytes), place, ": is of another format, expected PNG or JPEG");
  const std::optional<ImageSize> size = jpeg_size(bytes);
  require(size.has_value(), place, ": cannot be decoded, expected an undamaged JPEG");
  return *size;
}

ImageSize checked_size(const Bytes& encoded, const std::string& place) {
  const ImageSize size = encoded_size(encoded, place);
  require(size.width > 0 && size.height > 0, place, ": has no texels, expected at least one");
  require(size.height <= kMostTexels / size.width, place, ": has ", size.width, " x ", size.height,
          " texels, expected at most ", kMostTexels);
  return size;
}

cv::Mat_<cv::Vec4b> decode_png(const Bytes& encoded) {
  return vo::decode_png_rgba({reinterpret_cast<const char*>(encoded.data()), encoded.size()},
                             "PNG");
}

cv::Mat_<cv::Vec4b> decode_jpeg(const Bytes& encoded, ImageSize size) {
  const vo::ColorImage bgr =
      vo::decode_jpeg(encoded, {static_cast<int>(size.width), static_cast<int>(size.height)});
  cv::Mat_<cv::Vec4b> rgba(bgr.size());
  std::transform(bgr.begin(), bgr.end(), rgba.begin(), [](const cv::Vec3b& texel) {
    return cv::Vec4b(texel[2], texel[1], texel[0], 255);
  });
  return rgba;
}

}  // namespace

std::size_t texels_in(const Bytes& encoded, const std::string& place) {
  const ImageSize size = checked_size(encoded, place);
  return size.width * size.height;
}

cv::Mat_<cv::Vec4b> decode_image(const Bytes& encoded, const std::string& place) {
  const ImageSize size = checked_size(encoded, place);
  try {
    return is_png(encoded) ? decode_png(encoded) : decode_jpeg(encoded, size);
  } catch (const vo::Error& error) {
    if (error.kind() != vo::ErrorKind::input) {
      vo::fail_as(error.kind(), place, ": ", error.what());
    }
    vo::fail(place, ": cannot be decoded, expected an undamaged ", is_png(encoded) ? "PNG" : "JPEG",
             " (", error.what(), ")");
  }
}

}  // namespace synth
