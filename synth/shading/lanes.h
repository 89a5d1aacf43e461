#pragma once

#include <array>

namespace synth {

inline constexpr int kPacketSize = 16;  ///< number of rays that are traced together

/// One number for each ray of a packet, side by side so that the compiler can vectorise.
using Lanes = std::array<float, kPacketSize>;

/// Embree's mask of the lanes that hold a ray: -1 in those, 0 in the others.
using LaneMask = std::array<int, kPacketSize>;

struct Lanes3 {
  Lanes x{};
  Lanes y{};
  Lanes z{};
};

}  // namespace synth
