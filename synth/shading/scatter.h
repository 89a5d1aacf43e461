#pragma once

#include <Eigen/Core>

#include "synth/shading/surface.h"

namespace synth {

/// Two directions that make a right-handed frame with a third.
struct Frame {
  explicit Frame(const Eigen::Vector3f& normal);

  Eigen::Vector3f x;
  Eigen::Vector3f y;
  Eigen::Vector3f z;  ///< the normal
};

/// A point of the unit disc, spread evenly as the square is (Shirley & Chiu 1997, by angle).
Eigen::Vector2f on_disc(const Eigen::Vector2f& square);

/// Where light came from that leaves a surface towards its viewer.
struct Scattered {
  Eigen::Vector3f direction;  ///< unit
  Eigen::Vector3f weight;     ///< reflectance times cosine over density; zero: no light comes
};

/// Chosen as often as it matters: by the cosine for the diffuse share, by GGX's normals for the
/// specular one. `lobe` and `square` are random in [0, 1).
Scattered scatter(const SurfacePoint& point, float lobe, const Eigen::Vector2f& square);

}  // namespace synth
