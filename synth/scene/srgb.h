#pragma once

#include <array>
#include <cstdint>

namespace synth {

/// Encodes linear light in 0..1 as sRGB in 0..1 (IEC 61966-2-1).
float encode_srgb(float linear);
/// Decodes sRGB in 0..1 to linear light in 0..1 (IEC 61966-2-1).
float decode_srgb(float encoded);

/// Returns the 8-bit sRGB code nearest to linear light, clamped to 0..1, on the encoded scale.
std::uint8_t encode_srgb_8bit(float linear);
/// The linear light in 0..1 of each 8-bit sRGB code.
extern const std::array<float, 256> kLinearFromSrgb8bit;
inline float decode_srgb_8bit(std::uint8_t code) {
  return kLinearFromSrgb8bit[code];
}

}  // namespace synth
