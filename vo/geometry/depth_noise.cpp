#include "vo/geometry/depth_noise.h"

#include <cmath>

#include "vo/core/error.h"

namespace vo {

double DepthNoise::sigma(double depth) const {
  return std::hypot(constant, linear * depth, quadratic * depth * depth);
}

void DepthNoise::validate() const {
  for (const double term : {constant, linear, quadratic}) {
    require(term >= 0 && std::isfinite(term), "depth_noise: expected terms of at least 0, got ",
            term);
  }
}

DepthNoise known_depth_noise(const DepthNoise& noise) {
  return noise.is_known() ? noise : kStructuredLightNoise;
}

}  // namespace vo
