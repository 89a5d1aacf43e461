#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace synth {

/// What a depth camera looks at.
struct DepthView {
  vo::DepthImage depth;        ///< m along the optical axis; 0 = nothing
  cv::Mat_<cv::Vec3f> normal;  ///< unit, camera's axes, towards the camera; 0 = nothing
};

/// The angle between a surface's normal and the ray that sees it, rad.
double incidence(const DepthView& view, const vo::PinholeCamera& camera, const cv::Point& pixel);

enum class DepthSampling {
  nearest,  ///< the pixel that is hit
  linear,   ///< between four pixels: flying pixels at edges
};

constexpr auto enum_names(DepthSampling) {
  return std::array{std::pair{DepthSampling::nearest, "nearest"},
                    std::pair{DepthSampling::linear, "linear"}};
}

/// Each pixel has the depth of a place that is off in u and v by a normal number of standard
/// deviation sigma + grazing a / (pi / 2 - a) at an incidence a (Nguyen, Izadi & Lovell 2012).
struct LateralNoise {
  double sigma = 0;    ///< px
  double grazing = 0;  ///< px
  DepthSampling sampling = DepthSampling::nearest;
  std::uint64_t seed = 0;
};

/// Surfaces move along their normal by a normal number with that many pixels' width at their depth
/// (Handa, Whelan, McDonald & Davison 2014).
struct NormalNoise {
  double sigma = 0;    ///< px
  double grazing = 0;  ///< px
  std::uint64_t seed = 0;
};

/// Normal noise along the optical axis with a standard deviation at depth z and incidence a of
///     constant + linear max(z - linear_from, 0) + quadratic (z - quadratic_from)^2
///         + grazing / sqrt(z) a^2 / (pi / 2 - a)^2  above 60 degrees.
struct AxialNoise {
  double constant = 0;        ///< m
  double linear = 0;          ///< m per m
  double linear_from = 0;     ///< m
  double quadratic = 0;       ///< 1/m
  double quadratic_from = 0;  ///< m
  double grazing = 0;         ///< m^1.5
  double correlation = 0;     ///< px, between neighbours
  std::uint64_t seed = 0;

  bool is_on() const { return constant > 0 || linear > 0 || quadratic > 0 || grazing > 0; }
};

/// Depth is found as a disparity d = focal_baseline / Z that is noisy and a multiple of a step:
///     Z' = focal_baseline / (step round((d + sigma n + offset) / step)).
struct DisparityNoise {
  double focal_baseline = 0;  ///< px m, focal length times baseline; 0 = off
  double sigma = 0;           ///< px
  double step = 0;            ///< px; 0 = continuous
  double offset = 0;          ///< px
  double depth_step = 0;      ///< m, of the depth before; 0 = continuous
  double correlation = 0;     ///< px, between neighbours
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

/// sigma + grazing a / (pi / 2 - a), incidences above 85 degrees being taken as that.
double lateral_sigma(double sigma, double grazing, double incidence_rad);

double axial_sigma(const AxialNoise& noise, double depth, double incidence_rad);  ///< m

/// Each makes a new image; pixels without depth stay so.
vo::DepthImage with_normal_noise(const DepthView& view, const vo::PinholeCamera& camera,
                                 const NormalNoise& noise, std::uint64_t frame);
vo::DepthImage with_lateral_noise(const DepthView& view, const vo::PinholeCamera& camera,
                                  const LateralNoise& noise, std::uint64_t frame);
vo::DepthImage with_axial_noise(const DepthView& view, const vo::PinholeCamera& camera,
                                const AxialNoise& noise, std::uint64_t frame);
vo::DepthImage with_disparity_noise(const vo::DepthImage& depth, const DisparityNoise& noise,
                                    std::uint64_t frame);

}  // namespace synth
