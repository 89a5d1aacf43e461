#include "synth/gltf_model/image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include <tiny_gltf.h>

#include "vo/core/error.h"
#include "vo/image_files/jpeg_codec.h"

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

/// Copies the four channels of each texel, 16-bit ones rounded to 8 bits.
cv::Mat_<cv::Vec4b> to_rgba8(const tinygltf::Image& image) {
  cv::Mat_<cv::Vec4b> rgba(image.height, image.width);
  if (image.bits == 8) {
    std::memcpy(rgba.data, image.image.data(), rgba.total() * sizeof(cv::Vec4b));
    return rgba;
  }
  for (std::size_t i = 0; i < rgba.total() * 4; ++i) {
    std::uint16_t value = 0;
    std::memcpy(&value, image.image.data() + i * sizeof(value), sizeof(value));
    rgba.data[i] = static_cast<std::uint8_t>((value + 128U) / 257U);
  }
  return rgba;
}

cv::Mat_<cv::Vec4b> decode_png(const Bytes& encoded, ImageSize size, const std::string& place) {
  tinygltf::Image image;
  std::string error;
  const bool decoded = tinygltf::LoadImageData(
      &image, 0, &error, nullptr, static_cast<int>(size.width), static_cast<int>(size.height),
      encoded.data(), static_cast<int>(encoded.size()), nullptr);
  const std::size_t expected = size.width * size.height * 4 * static_cast<unsigned>(image.bits) / 8;
  require(decoded && image.image.size() == expected, place,
          ": cannot be decoded, expected an undamaged PNG");
  return to_rgba8(image);
}

/// Decodes a JPEG by libjpeg-turbo, as tinygltf's decoder writes out of bounds on damaged files.
cv::Mat_<cv::Vec4b> decode_opaque(const Bytes& encoded, ImageSize size, const std::string& place) {
  vo::ColorImage bgr;
  try {
    bgr = vo::decode_jpeg(encoded, {static_cast<int>(size.width), static_cast<int>(size.height)});
  } catch (const vo::Error& error) {
    vo::fail(place, ": cannot be decoded, expected an undamaged JPEG (", error.what(), ")");
  }
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
  require(encoded.size() <= std::numeric_limits<int>::max(), place, ": has ", encoded.size(),
          " bytes, expected less than 2 GB");
  return is_png(encoded) ? decode_png(encoded, size, place) : decode_opaque(encoded, size, place);
}

}  // namespace synth
