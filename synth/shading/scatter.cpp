#include "synth/shading/scatter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "synth/shading/shading.h"

namespace synth {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Returns the share of the samples that follow the specular lobe: its part in what the surface
/// reflects towards the viewer, taken as that of a smooth one, and not less than a tenth.
float specular_share(const SurfacePoint& point) {
  const float n_v = point.normal.dot(point.to_viewer);
  if (!(n_v > 0) || (point.metallic == 0 && point.specular == 0)) {
    return 0;
  }
  constexpr float kLeast = 0.1F;
  const float m = 1 - std::min(1.0F, n_v);
  const float grazing = m * m * m * m * m;
  const float straight = point.normal_reflectance.maxCoeff();
  const float glass = point.specular * (straight + (1 - straight) * grazing);
  const float base = point.base_color.maxCoeff();
  const float metal = base + (1 - base) * grazing;
  const float gloss = glass + point.metallic * (metal - glass);
  const float matt = (1 - point.metallic) * (1 - glass) * base;
  return std::clamp(gloss / std::max(gloss + matt, 1e-6F), kLeast, 1 - kLeast);
}

Eigen::Vector3f place(const Frame& frame, const Eigen::Vector3f& local) {
  return frame.x * local.x() + frame.y * local.y() + frame.z * local.z();
}

Eigen::Vector3f cosine_direction(const Frame& frame, const Eigen::Vector2f& square) {
  const Eigen::Vector2f disc = on_disc(square);
  const float z = std::sqrt(std::max(0.0F, 1 - disc.squaredNorm()));
  return place(frame, {disc.x(), disc.y(), z});
}

/// Returns the density, 1/sr, of the directions mirrored by visible normals: G1 D / (4 n.v).
float mirrored_density(const SurfacePoint& point, float alpha, const Eigen::Vector3f& direction) {
  const Eigen::Vector3f half = (direction + point.to_viewer).normalized();
  const float alpha2 = alpha * alpha;
  const float n_h = std::clamp(point.normal.dot(half), 0.0F, 1.0F);
  const float n_v = point.normal.dot(point.to_viewer);
  const float spread = n_h * n_h * (alpha2 - 1) + 1;
  const float masking = n_v + std::sqrt(alpha2 + (1 - alpha2) * n_v * n_v);
  return alpha2 / (2 * kPi * spread * spread * masking);
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

/// The viewer's direction is stretched to a surface of alpha 1, whose visible normals fill a disc,
/// part of it foreshortened.
Eigen::Vector3f visible_normal(const Frame& frame, float alpha, const Eigen::Vector3f& to_viewer,
                               const Eigen::Vector2f& square) {
  const Eigen::Vector3f viewer =
      Eigen::Vector3f(alpha * to_viewer.dot(frame.x), alpha * to_viewer.dot(frame.y),
                      to_viewer.dot(frame.z))
          .normalized();
  const Eigen::Vector2f disc = on_disc(square);
  // The viewer leans from the normal about `across`, along which the disc is not foreshortened.
  const Eigen::Vector3f leaning = Eigen::Vector3f::UnitZ().cross(viewer);
  const float sine = leaning.norm();
  const Eigen::Vector3f across =
      sine > 1e-6F ? Eigen::Vector3f(leaning / sine) : Eigen::Vector3f::UnitX();
  const Eigen::Vector3f along = viewer.cross(across);
  const float half = 0.5F * (1 + viewer.z());
  const float whole = std::sqrt(std::max(0.0F, 1 - disc.x() * disc.x()));
  const float y = (1 - half) * whole + half * disc.y();
  const float z = std::sqrt(std::max(0.0F, 1 - disc.x() * disc.x() - y * y));
  const Eigen::Vector3f stretched = disc.x() * across + y * along + z * viewer;
  const Eigen::Vector3f normal(alpha * stretched.x(), alpha * stretched.y(),
                               std::max(1e-6F, stretched.z()));
  return place(frame, normal.normalized());
}

float scatter_density(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  const float n_l = point.normal.dot(direction);
  if (!(n_l > 0) || point.face_normal.dot(direction) <= 0) {
    return 0;
  }
  const float share = specular_share(point);
  const float mirrored = share > 0 ? mirrored_density(point, ggx_alpha(point), direction) : 0;
  return share * mirrored + (1 - share) * n_l / kPi;
}

Scattered scatter(const SurfacePoint& point, float lobe, const Eigen::Vector2f& square) {
  const Frame frame(point.normal);
  Scattered result{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
  if (lobe < specular_share(point)) {
    const Eigen::Vector3f half = visible_normal(frame, ggx_alpha(point), point.to_viewer, square);
    result.direction = 2 * point.to_viewer.dot(half) * half - point.to_viewer;
  } else {
    result.direction = cosine_direction(frame, square);
  }
  result.density = scatter_density(point, result.direction);
  if (!(result.density > 0)) {
    return result;
  }
  const bool is_lambertian = point.metallic == 0 && point.specular == 0;
  const float n_l = point.normal.dot(result.direction);
  result.weight =
      is_lambertian
          ? point.base_color  // the cosine and its density cancel
          : Eigen::Vector3f(reflectance(point, result.direction) * (n_l / result.density));
  return result;
}

}  // namespace synth
