#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "vo/core/image.h"

namespace vo {

enum class ChromaSampling {
  full,    ///< 4:4:4
  half,    ///< 4:2:2, half the columns
  quarter  ///< 4:2:0, half the columns and rows
};

constexpr auto enum_names(ChromaSampling) {
  return std::array{std::pair{ChromaSampling::full, "full"},
                    std::pair{ChromaSampling::half, "half"},
                    std::pair{ChromaSampling::quarter, "quarter"}};
}

/// Encodes the image as a JPEG file, with a `quality` from 1 to 100.
std::vector<std::uint8_t> encode_jpeg(const ColorImage& image, int quality, ChromaSampling chroma);

/// Decodes a JPEG file. Throws vo::Error if it cannot be decoded, or if its size is not the
/// expected one, which is found before the image is allocated.
ColorImage decode_jpeg(std::span<const std::uint8_t> bytes, cv::Size size);

/// Returns whether bytes begin as those of a JPEG file do.
bool is_jpeg(std::string_view bytes);

/// Decodes a JPEG file as grey (CV_8UC1), if it is grey, or colour (CV_8UC3, BGR). Throws Error
/// naming `path`, the file that the bytes are of, if they cannot be decoded or end too early.
cv::Mat decode_jpeg(std::string_view bytes, const std::filesystem::path& path);

}  // namespace vo
