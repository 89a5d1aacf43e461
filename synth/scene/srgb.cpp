#include "synth/scene/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace synth {
namespace {

std::array<float, 256> make_decoding_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = decode_srgb(static_cast<float>(i) / 255.0F);
  }
  return table;
}

/// The linear values that separate neighbouring 8-bit codes: code k lies below threshold k.
std::array<float, 255> make_encoding_thresholds() {
  std::array<float, 255> thresholds{};
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    thresholds[i] = decode_srgb((static_cast<float>(i) + 0.5F) / 255.0F);
  }
  return thresholds;
}

const std::array<float, 255> kCodeThresholds = make_encoding_thresholds();

}  // namespace

const std::array<float, 256> kLinearFromSrgb8bit = make_decoding_table();

float encode_srgb(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

float decode_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t encode_srgb_8bit(float linear) {
  if (!(linear > 0)) {
    return 0;
  }
  const auto* above = std::upper_bound(kCodeThresholds.begin(), kCodeThresholds.end(), linear);
  return static_cast<std::uint8_t>(above - kCodeThresholds.begin());
}

}  // namespace synth
