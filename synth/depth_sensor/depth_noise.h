#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// The exact depth and normals that a depth camera observes.
struct DepthView {
  vo::DepthImage depth;        ///< m, CameraModel::depth; 0 = nothing
  cv::Mat_<cv::Vec3f> normal;  ///< unit normal, camera's axes, towards the camera; 0 = nothing
};

/// Returns the angle between a pixel's surface normal and its ray, rad.
double incidence(const DepthView& view, const vo::CameraModel& camera, const cv::Point& pixel);

enum class DepthSampling {
  nearest,  ///< depth of the nearest pixel
  linear,   ///< bilinear interpolation, with flying pixels at depth edges
};

constexpr auto enum_names(DepthSampling) {
  return std::array{std::pair{DepthSampling::nearest, "nearest"},
                    std::pair{DepthSampling::linear, "linear"}};
}

/// Each pixel takes the depth of a position displaced in u and v by Gaussian noise of standard
/// deviation sigma + grazing a / (pi / 2 - a) at incidence a (Nguyen, Izadi & Lovell 2012).
struct LateralNoise {
  double sigma = 0;    ///< px, standard deviation at incidence 0
  double grazing = 0;  ///< px, growth of the standard deviation with incidence
  DepthSampling sampling = DepthSampling::nearest;
  std::uint64_t seed = 0;
};

/// Noise along the surface normal, of standard deviation sigma + grazing a / (pi / 2 - a) pixel
/// widths at the surface's depth, at incidence a (Handa, Whelan, McDonald & Davison 2014).
struct NormalNoise {
  double sigma = 0;    ///< px, standard deviation at incidence 0
  double grazing = 0;  ///< px, growth of the standard deviation with incidence
  std::uint64_t seed = 0;
};

/// Gaussian noise along the optical axis, of standard deviation at depth z and incidence a
///     constant + linear max(z - linear_from, 0) + quadratic (z - quadratic_from)^2
///         + grazing / sqrt(z) a^2 / (pi / 2 - a)^2  above 60 degrees.
struct AxialNoise {
  double constant = 0;        ///< m, standard deviation at any depth
  double linear = 0;          ///< m per m, growth with depth beyond linear_from
  double linear_from = 0;     ///< m, depth from which the linear term grows
  double quadratic = 0;       ///< 1/m, factor of the quadratic term
  double quadratic_from = 0;  ///< m, depth where the quadratic term is 0
  double grazing = 0;         ///< m^1.5, factor of the term above 60 degrees
  double correlation = 0;     ///< px, blur sigma that correlates neighbours
  std::uint64_t seed = 0;

  bool is_on() const { return constant > 0 || linear > 0 || quadratic > 0 || grazing > 0; }
};

/// Noise and rounding of a disparity d = focal_baseline / Z from which depth is measured:
///     Z' = focal_baseline / (step round((d + sigma n + offset) / step)).
struct DisparityNoise {
  double focal_baseline = 0;  ///< px m, focal length times baseline; 0 = off
  double sigma = 0;           ///< px, standard deviation of the disparity
  double step = 0;            ///< px, quantisation of the disparity; 0 = continuous
  double offset = 0;          ///< px, added to the disparity
  double depth_step = 0;      ///< m, quantisation of the input depth; 0 = continuous
  double correlation = 0;     ///< px, blur sigma that correlates neighbours
  std::uint64_t seed = 0;
};

template <typename Visitor>
void visit_fields(Visitor& visit, LateralNoise& noise) {
  visit("sigma", noise.sigma, "standard deviation of the place that is measured, px");
  visit("grazing", noise.grazing, "times a / (pi / 2 - a) at an incidence a, px");
  visit("sampling", noise.sampling, "what lies there");
  visit("seed", noise.seed, "of this noise");
}

template <typename Visitor>
void visit_fields(Visitor& visit, NormalNoise& noise) {
  visit("sigma", noise.sigma, "standard deviation along the normal, px at that depth");
  visit("grazing", noise.grazing, "times a / (pi / 2 - a) at an incidence a, px");
  visit("seed", noise.seed, "of this noise");
}

template <typename Visitor>
void visit_fields(Visitor& visit, AxialNoise& noise) {
  visit("constant", noise.constant, "standard deviation at any depth, m");
  visit("linear", noise.linear, "and times (z - linear_from) above it");
  visit("linear_from", noise.linear_from, "m");
  visit("quadratic", noise.quadratic, "and times (z - quadratic_from)^2, 1/m");
  visit("quadratic_from", noise.quadratic_from, "m");
  visit("grazing", noise.grazing, "times z^-1/2 a^2 / (pi / 2 - a)^2 above 60 deg, m^1.5");
  visit("correlation", noise.correlation, "between neighbours, px");
  visit("seed", noise.seed, "of this noise");
}

template <typename Visitor>
void visit_fields(Visitor& visit, DisparityNoise& noise) {
  visit("focal_baseline", noise.focal_baseline, "focal length times baseline, px m; 0 = off");
  visit("sigma", noise.sigma, "standard deviation of the disparity, px");
  visit("step", noise.step, "of the disparity, px; 0 = continuous");
  visit("offset", noise.offset, "added to the disparity, px");
  visit("depth_step", noise.depth_step, "of the depth before, m; 0 = continuous");
  visit("correlation", noise.correlation, "between neighbours, px");
  visit("seed", noise.seed, "of this noise");
}

/// Returns sigma + grazing a / (pi / 2 - a) at incidence a, which is limited to 85 degrees.
double lateral_sigma(double sigma, double grazing, double incidence_rad);

double axial_sigma(const AxialNoise& noise, double depth, double incidence_rad);  ///< sigma, m

/// Returns depth with noise along the normals, or the input image itself if the noise is off.
vo::DepthImage with_normal_noise(const DepthView& view, const vo::CameraModel& camera,
                                 const NormalNoise& noise, std::uint64_t frame);
/// Returns depth with lateral noise, or the input image itself if the noise is off.
vo::DepthImage with_lateral_noise(const DepthView& view, const vo::CameraModel& camera,
                                  const LateralNoise& noise, std::uint64_t frame);
/// Returns depth with axial noise, or the input image itself if the noise is off.
vo::DepthImage with_axial_noise(const DepthView& view, const vo::CameraModel& camera,
                                const AxialNoise& noise, std::uint64_t frame);
/// Returns depth with disparity noise, or the input image itself if the noise is off.
vo::DepthImage with_disparity_noise(const vo::DepthImage& depth, const DisparityNoise& noise,
                                    std::uint64_t frame);

}  // namespace synth
