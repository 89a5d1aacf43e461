#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "synth/scene/scene.h"
#include "synth/shading/drawn_light.h"

namespace synth {

/// The light that comes from infinitely far, of a scene's environment, and directions drawn by how
/// much of it comes from there.
class EnvironmentLight {
 public:
  EnvironmentLight() = default;  ///< no light
  /// The environment must outlive its light.
  explicit EnvironmentLight(const Environment& environment);

  bool empty() const { return environment_ == nullptr; }

  /// Returns the radiance, linear RGB, from a unit direction, interpolated between pixels.
  Eigen::Vector3f radiance(const Eigen::Vector3f& direction) const;

  /// Returns the light from a direction drawn at random, which surfaces may hide; `square` is
  /// random in [0, 1) x [0, 1).
  DrawnLight draw(const Eigen::Vector2f& square) const;

  /// Returns the density, 1/sr, with which `draw` returns a unit direction.
  float density(const Eigen::Vector3f& direction) const;

 private:
  std::size_t column_begin(int row) const;
  float solid_angle(int row) const;  ///< sr, of one pixel

  const Environment* environment_ = nullptr;
  Eigen::Matrix3f R_world_environment_ = Eigen::Matrix3f::Identity();
  std::vector<float> rows_;     ///< probability of all rows up to and including this one
  std::vector<float> columns_;  ///< per row: probability in it of all columns up to this one
};

/// The irradiance of light from infinitely far on a surface as a function of its normal: the bands
/// 0 to 2 of spherical harmonics, which hold 99 % of it (Ramamoorthi & Hanrahan, An efficient
/// representation for irradiance environment maps, 2001).
class EnvironmentIrradiance {
 public:
  explicit EnvironmentIrradiance(const Environment& environment);

  /// Returns the irradiance, lx, linear RGB, on a surface of this unit normal; at least 0.
  Eigen::Vector3f operator()(const Eigen::Vector3f& normal) const;

 private:
  std::array<Eigen::Vector3f, 9> coefficients_;
};

}  // namespace synth
