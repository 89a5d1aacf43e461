#pragma once

#include <array>

namespace synth {

inline constexpr int kPacketSize = 16;  ///< rays that are traced together

/// A number of each ray of a packet: side by side, so that the compiler works on several at once.
using Lanes = std::array<float, kPacketSize>;

/// Embree's way to say which lanes hold a ray: -1 in them, 0 in the others.
using LaneMask = std::array<int, kPacketSize>;

struct Lanes3 {
  Lanes x{};
  Lanes y{};
  Lanes z{};
};

}  // namespace synth
