#pragma once

#include <array>
#include <cstdint>
#include <span>
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

}  // namespace vo
