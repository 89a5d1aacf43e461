#pragma once

#include <array>
#include <cstdint>

namespace synth {

/// Linear light in 0..1 to sRGB in 0..1 and back (IEC 61966-2-1).
float encode_srgb(float linear);
float decode_srgb(float encoded);

/// The same for 8-bit codes, from tables: the code whose light is nearest in the encoded scale,
/// values outside 0..1 clamped, and a code's linear light.
std::uint8_t encode_srgb_8bit(float linear);
extern const std::array<float, 256> kLinearFromSrgb8bit;
inline float decode_srgb_8bit(std::uint8_t code) {
  return kLinearFromSrgb8bit[code];
}

}  // namespace synth
