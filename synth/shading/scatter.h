#pragma once

#include <Eigen/Core>

#include "synth/shading/surface.h"

namespace synth {

/// An orthonormal right-handed frame about a surface normal.
struct Frame {
  explicit Frame(const Eigen::Vector3f& normal);

  Eigen::Vector3f x;
  Eigen::Vector3f y;
  Eigen::Vector3f z;  ///< the normal
};

/// Returns a point of the unit disc, uniform if `square` is, by the area-preserving polar mapping.
Eigen::Vector2f on_disc(const Eigen::Vector2f& square);

/// Returns a random microfacet normal of those that the viewer sees of GGX's (Heitz, Sampling the
/// GGX distribution of visible normals, 2018). `to_viewer` is unit, `square` random in [0, 1).
Eigen::Vector3f visible_normal(const Frame& frame, float alpha, const Eigen::Vector3f& to_viewer,
                               const Eigen::Vector2f& square);

/// A sampled direction of incident light, and its weight in the radiance towards the viewer.
struct Scattered {
  Eigen::Vector3f direction;  ///< unit, from the surface towards the light
  Eigen::Vector3f weight;     ///< BRDF times cosine over density; zero: no light comes
  float density = 0;          ///< 1/sr, `scatter_density` of the direction
};

/// Returns an importance-sampled direction: by the cosine for the diffuse lobe, by the normals that
/// the viewer sees for the specular one. `lobe` and `square` are random in [0, 1).
Scattered scatter(const SurfacePoint& point, float lobe, const Eigen::Vector2f& square);

/// Returns the density, 1/sr, with which `scatter` returns a unit direction; zero behind the
/// surface.
float scatter_density(const SurfacePoint& point, const Eigen::Vector3f& direction);

}  // namespace synth
