#pragma once

#include <cmath>
#include <numbers>

namespace vo {

/// Returns the solid angle, sr, of each pixel of a row of an equirectangular image that is twice as
/// wide as it has rows.
inline double pixel_solid_angle(int row, int rows) {
  const double step = std::numbers::pi / rows;
  return step * (std::cos(row * step) - std::cos((row + 1) * step));
}

}  // namespace vo
