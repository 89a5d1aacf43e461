#include "synth/shading/scatter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "synth/shading/shading.h"

namespace synth {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Returns the share of the samples that follow the specular lobe.
float specular_share(const SurfacePoint& point) {
  const float dielectric = point.specular > 0 ? 0.25F : 0.0F;
  return dielectric + point.metallic * (0.9F - dielectric);
}

Eigen::Vector3f place(const Frame& frame, const Eigen::Vector3f& local) {
  return frame.x * local.x() + frame.y * local.y() + frame.z * local.z();
}

Eigen::Vector3f cosine_direction(const Frame& frame, const Eigen::Vector2f& square) {
  const Eigen::Vector2f disc = on_disc(square);
  const float z = std::sqrt(std::max(0.0F, 1 - disc.squaredNorm()));
  return place(frame, {disc.x(), disc.y(), z});
}

/// Returns a random microfacet normal, of density D n.h.
Eigen::Vector3f ggx_normal(const Frame& frame, float alpha, const Eigen::Vector2f& square) {
  const float cos2 = (1 - square.x()) / (1 + (alpha * alpha - 1) * square.x());
  const float sine = std::sqrt(std::max(0.0F, 1 - cos2));
  const float angle = 2 * kPi * square.y();
  return place(frame, {sine * std::cos(angle), sine * std::sin(angle), std::sqrt(cos2)});
}

float ggx_density(const SurfacePoint& point, float alpha, const Eigen::Vector3f& direction) {
  const Eigen::Vector3f half = (direction + point.to_viewer).normalized();
  const float n_h = std::max(0.0F, point.normal.dot(half));
  const float spread = n_h * n_h * (alpha * alpha - 1) + 1;
  const float v_h = std::max(1e-4F, point.to_viewer.dot(half));
  return alpha * alpha * n_h / (kPi * spread * spread * 4 * v_h);
}

}  // namespace

/// Completes the frame after Duff et al., Building an orthonormal basis, revisited, 2017.
Frame::Frame(const Eigen::Vector3f& normal) {
  z = normal;
  const float sign = std::copysign(1.0F, z.z());
  const float a = -1 / (sign + z.z());
  const float b = z.x() * z.y() * a;
  x = {1 + sign * z.x() * z.x() * a, sign * b, -sign * z.x()};
  y = {b, sign + z.y() * z.y() * a, -z.y()};
}

Eigen::Vector2f on_disc(const Eigen::Vector2f& square) {
  const float radius = std::sqrt(square.x());
  const float angle = 2 * kPi * square.y();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Scattered scatter(const SurfacePoint& point, float lobe, const Eigen::Vector2f& square) {
  const Frame frame(point.normal);
  const float share = specular_share(point);
  const float alpha = ggx_alpha(point);
  Scattered result{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  if (lobe < share) {
    const Eigen::Vector3f half = ggx_normal(frame, alpha, square);
    result.direction = 2 * point.to_viewer.dot(half) * half - point.to_viewer;
  } else {
    result.direction = cosine_direction(frame, square);
  }
  const float n_l = point.normal.dot(result.direction);
  if (!(n_l > 0) || point.face_normal.dot(result.direction) <= 0) {
    return result;
  }
  if (share == 0) {
    result.weight = point.base_color;  // Lambert's: the cosine and its density cancel
    return result;
  }
  const float density =
      share * ggx_density(point, alpha, result.direction) + (1 - share) * n_l / kPi;
  result.weight = reflectance(point, result.direction) * (n_l / density);
  return result;
}

}  // namespace synth
