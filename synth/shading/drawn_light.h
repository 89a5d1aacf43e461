#pragma once

#include <Eigen/Core>

namespace synth {

/// Light that a surface point may receive from a direction drawn at random.
struct DrawnLight {
  Eigen::Vector3f to_light = Eigen::Vector3f::Zero();  ///< m to its source; unit if far away
  Eigen::Vector3f radiance = Eigen::Vector3f::Zero();  ///< linear RGB, towards the point
  float density = 0;  ///< 1/sr, of the direction; zero: no light comes from there
};

/// Returns the weight of a sample of density `own` beside samples of density `other` of the same
/// integral: the power heuristic of exponent 2 (Veach & Guibas, Optimally combining sampling
/// techniques for Monte Carlo rendering, 1995). The weights of both sum to 1.
inline float sample_weight(float own, float other) {
  return own > 0 ? 1 / (1 + (other / own) * (other / own)) : 0;
}

}  // namespace synth
