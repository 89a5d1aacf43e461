#include "vo/geometry/lens.h"

#include <algorithm>
#include <numbers>

#include <Eigen/LU>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr int kMaxIterations = 20;
constexpr double kConverged = 1e-14;
constexpr double kWidest = 85 * std::numbers::pi / 180;  // rad, angle off the axis a fisheye sees

Eigen::Vector2d remove_brown_conrady(const Distortion& lens, const Eigen::Vector2d& distorted) {
  Eigen::Vector2d ideal = distorted;
  for (int i = 0; i < kMaxIterations; ++i) {
    const DistortedPoint<double> imaged = distort(lens, ideal.x(), ideal.y());
    const Eigen::Vector2d error = Eigen::Vector2d(imaged.x, imaged.y) - distorted;
    if (error.norm() < kConverged) {
      break;
    }
    Eigen::Matrix2d J;
    J << imaged.dx_dx, imaged.dx_dy, imaged.dx_dy, imaged.dy_dy;
    ideal -= J.inverse() * error;
  }
  return ideal;
}

Eigen::Vector2d remove_kannala_brandt(const Distortion& lens, const Eigen::Vector2d& distorted) {
  const double radius = distorted.norm();
  if (radius < kConverged) {
    return distorted;
  }
  double angle = std::min(radius, kWidest);
  for (int i = 0; i < kMaxIterations; ++i) {
    const ImagedAngle<double> imaged = image_angle(lens, angle);
    const double step = (imaged.radius - radius) / imaged.slope;
    angle -= step;
    if (std::abs(step) < kConverged) {
      break;
    }
  }
  if (!(angle > 0 && angle < kWidest)) {
    return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  return std::tan(angle) / radius * distorted;
}

/// Throws Error where the radius at which a lens images an angle, `imaged_at`, does not grow with
/// the angle, rad, within `image_radius`.
template <typename ImagedAt>
void require_growth(const char* model, double image_radius, const ImagedAt& imaged_at) {
  constexpr int kAngles = 170;
  for (int i = 1; i <= kAngles; ++i) {
    const ImagedAngle<double> imaged = imaged_at(kWidest * i / kAngles);
    require(imaged.slope > 0 || imaged.radius > image_radius, "camera.distortion: ", model,
            " folds over inside the image, ", 0.5 * i,
            " deg off the axis, expected coefficients that can be inverted up to its corners");
    if (imaged.radius > image_radius) {
      return;
    }
  }
}

/// Returns where a lens with a denominator images an angle, without its tangential terms; behind a
/// pole it grows no more.
ImagedAngle<double> image_rational(const Distortion& lens, double angle) {
  const double r = std::tan(angle);
  const RationalFactor<double> radial = rational_factor(lens, r * r);
  if (!(radial.denominator > 0)) {
    return {0, 0};
  }
  return {radial.factor * r, (radial.factor + 2 * r * r * radial.slope) * (1 + r * r)};
}

}  // namespace

Eigen::Vector2d Distortion::remove(const Eigen::Vector2d& distorted) const {
  return model == DistortionModel::kannala_brandt ? remove_kannala_brandt(*this, distorted)
                                                  : remove_brown_conrady(*this, distorted);
}

void Distortion::validate(double image_radius) const {
  if (is_rational()) {
    require_growth("brown_conrady", image_radius,
                   [&](double angle) { return image_rational(*this, angle); });
  }
  if (model == DistortionModel::brown_conrady) {
    return;
  }
  require(
      p1 == 0 && p2 == 0 && k5 == 0 && k6 == 0,
      "camera.distortion: kannala_brandt has k1 to k4 alone, expected p1, p2, k5 and k6 to be 0, "
      "got ",
      p1, ", ", p2, ", ", k5, ", ", k6);
  require_growth("kannala_brandt", image_radius,
                 [&](double angle) { return image_angle(*this, angle); });
}

}  // namespace vo
