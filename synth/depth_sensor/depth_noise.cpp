#include "synth/depth_sensor/depth_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synth/depth_sensor/gaussian.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr std::uint64_t kLateral = 0x1a7e;
constexpr std::uint64_t kNormal = 0x2047;
constexpr std::uint64_t kAxial = 0xa41a;
constexpr std::uint64_t kDisparity = 0xd15b;
constexpr double kRightAngle = std::numbers::pi / 2;

/// Returns `change(pixel, depth)` where there is depth; 0 elsewhere and for invalid results.
template <typename Change>
vo::DepthImage changed(const vo::DepthImage& depth, const Change& change) {
  vo::DepthImage result(depth.size(), 0.0F);
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      if (vo::has_depth(depth(v, u))) {
        const double value = change(cv::Point(u, v), static_cast<double>(depth(v, u)));
        result(v, u) = value > 0 && std::isfinite(value) ? static_cast<float>(value) : 0.0F;
      }
    }
  }
  return result;
}

double rounded_to(double value, double step) {
  return step > 0 ? step * std::round(value / step) : value;
}

/// Returns the depth at a position within the image, m.
float sampled(const vo::DepthImage& depth, double u, double v, DepthSampling sampling) {
  const float nearest = depth(static_cast<int>(std::lround(v)), static_cast<int>(std::lround(u)));
  if (sampling == DepthSampling::nearest) {
    return nearest;
  }
  const int u0 = std::min(static_cast<int>(u), std::max(0, depth.cols - 2));
  const int v0 = std::min(static_cast<int>(v), std::max(0, depth.rows - 2));
  const int u1 = std::min(u0 + 1, depth.cols - 1);
  const int v1 = std::min(v0 + 1, depth.rows - 1);
  const auto a = static_cast<float>(u - u0);
  const auto b = static_cast<float>(v - v0);
  if (!vo::has_depth(depth(v0, u0)) || !vo::has_depth(depth(v0, u1)) ||
      !vo::has_depth(depth(v1, u0)) || !vo::has_depth(depth(v1, u1))) {
    return nearest;
  }
  return (1 - b) * ((1 - a) * depth(v0, u0) + a * depth(v0, u1)) +
         b * ((1 - a) * depth(v1, u0) + a * depth(v1, u1));
}

}  // namespace

double incidence(const DepthView& view, const vo::CameraModel& camera, const cv::Point& pixel) {
  const cv::Vec3f& normal = view.normal(pixel);
  const Eigen::Vector3d ray = camera.ray(Eigen::Vector2d(pixel.x, pixel.y));
  const double cosine =
      std::abs(ray.dot(Eigen::Vector3d(normal[0], normal[1], normal[2]))) / ray.norm();
  return std::acos(std::clamp(cosine, 0.0, 1.0));
}

double lateral_sigma(double sigma, double grazing, double incidence_rad) {
  constexpr double kMaxIncidence = 85 * std::numbers::pi / 180;
  const double angle = std::min(incidence_rad, kMaxIncidence);
  return sigma + grazing * angle / (kRightAngle - angle);
}

double axial_sigma(const AxialNoise& noise, double depth, double incidence_rad) {
  constexpr double kGrazing = std::numbers::pi / 3;
  constexpr double kMaxIncidence = 85 * std::numbers::pi / 180;
  const double beyond = depth - noise.quadratic_from;
  double sigma = noise.constant + noise.linear * std::max(depth - noise.linear_from, 0.0) +
                 noise.quadratic * beyond * beyond;
  if (incidence_rad > kGrazing) {
    const double angle = std::min(incidence_rad, kMaxIncidence);
    const double slope = angle / (kRightAngle - angle);
    sigma += noise.grazing / std::sqrt(depth) * slope * slope;
  }
  return sigma;
}

vo::DepthImage with_normal_noise(const DepthView& view, const vo::CameraModel& camera,
                                 const NormalNoise& noise, std::uint64_t frame) {
  if (noise.sigma == 0 && noise.grazing == 0) {
    return view.depth;
  }
  const double focal_px = camera.pinhole_for("sensor.depth.normal").fx;
  const vo::RandomField random(noise.seed, kNormal, frame);
  return changed(view.depth, [&](const cv::Point& pixel, double depth) {
    const double sigma_px =
        lateral_sigma(noise.sigma, noise.grazing, incidence(view, camera, pixel));
    const double shift = random.normal(pixel.x, pixel.y) * sigma_px * depth / focal_px;
    return depth + shift * view.normal(pixel)[2];
  });
}

vo::DepthImage with_lateral_noise(const DepthView& view, const vo::CameraModel& camera,
                                  const LateralNoise& noise, std::uint64_t frame) {
  if (noise.sigma == 0 && noise.grazing == 0) {
    return view.depth;
  }
  const vo::RandomField random(noise.seed, kLateral, frame);
  return changed(view.depth, [&](const cv::Point& pixel, double) {
    const double angle = noise.grazing > 0 ? incidence(view, camera, pixel) : 0;
    const double sigma_px = lateral_sigma(noise.sigma, noise.grazing, angle);
    const double u = pixel.x + sigma_px * random.normal(pixel.x, pixel.y, 0);
    const double v = pixel.y + sigma_px * random.normal(pixel.x, pixel.y, 1);
    return sampled(view.depth, std::clamp(u, 0.0, view.depth.cols - 1.0),
                   std::clamp(v, 0.0, view.depth.rows - 1.0), noise.sampling);
  });
}

vo::DepthImage with_axial_noise(const DepthView& view, const vo::CameraModel& camera,
                                const AxialNoise& noise, std::uint64_t frame) {
  if (!noise.is_on()) {
    return view.depth;
  }
  const cv::Mat_<float> normals =
      noise_image(view.depth.size(), noise.correlation, {noise.seed, kAxial, frame});
  return changed(view.depth, [&](const cv::Point& pixel, double depth) {
    const double angle = noise.grazing > 0 ? incidence(view, camera, pixel) : 0;
    return depth + axial_sigma(noise, depth, angle) * normals(pixel);
  });
}

vo::DepthImage with_disparity_noise(const vo::DepthImage& depth, const DisparityNoise& noise,
                                    std::uint64_t frame) {
  if (noise.focal_baseline == 0) {
    return depth;
  }
  const cv::Mat_<float> normals =
      noise_image(depth.size(), noise.correlation, {noise.seed, kDisparity, frame});
  return changed(depth, [&](const cv::Point& pixel, double value) {
    const double disparity = noise.focal_baseline / rounded_to(value, noise.depth_step);
    return noise.focal_baseline /
           rounded_to(disparity + noise.sigma * normals(pixel) + noise.offset, noise.step);
  });
}

}  // namespace synth
