#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "synth/scene/scene.h"
#include "synth/shading/drawn_light.h"

namespace synth {

/// The light that comes from infinitely far, of a scene's environment, which must outlive it.
class EnvironmentLight {
 public:
  explicit EnvironmentLight(const Environment& environment);

  bool empty() const { return environment_.empty(); }
  const cv::Mat_<cv::Vec3f>& image() const { return environment_.radiance; }

  /// Returns the radiance, linear RGB, from a unit direction, interpolated between pixels.
  Eigen::Vector3f radiance(const Eigen::Vector3f& direction) const;

  Eigen::Vector3f in_image_axes(const Eigen::Vector3f& direction) const {
    return R_world_environment_.transpose() * direction;
  }
  Eigen::Vector3f in_world_axes(const Eigen::Vector3f& direction) const {
    return R_world_environment_ * direction;
  }

 private:
  const Environment& environment_;
  Eigen::Matrix3f R_world_environment_;
};

/// Directions drawn by how much of an environment's light comes from there. The light must outlive
/// them and not be empty.
class EnvironmentDirections {
 public:
  explicit EnvironmentDirections(const EnvironmentLight& light);

  /// Returns the light from a direction drawn at random, which surfaces may hide; `square` is
  /// random in [0, 1) x [0, 1).
  DrawnLight draw(const Eigen::Vector2f& square) const;

  /// Returns the density, 1/sr, with which `draw` returns a unit direction.
  float density(const Eigen::Vector3f& direction) const;

 private:
  std::size_t column_begin(int row) const;

  const EnvironmentLight& light_;
  std::vector<float> rows_;     ///< probability of all rows up to and including this one
  std::vector<float> per_sr_;   ///< per row: its probability over a pixel's solid angle, 1/sr
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
