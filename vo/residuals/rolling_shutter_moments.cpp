#include "vo/residuals/rolling_shutter_moments.h"

namespace vo {
namespace {

using Jacobian = Eigen::Matrix<float, kPassParameters, 1>;
using Sum = Eigen::Matrix<float, kPassParameters, 6>;

Jacobian jacobian_of(const PointTerms& scores, std::size_t i) {
  Jacobian J;
  for (std::size_t p = 0; p < kPassParameters; ++p) {
    J[static_cast<Eigen::Index>(p)] = scores.J[p][i];
  }
  return J;
}

}  // namespace

RollingShutterMoments RollingShutterMoments::of(const PointView& view, const PointTerms& scores) {
  const float inverse_height = 1 / static_cast<float>(view.image.camera.height);
  Sum points = Sum::Zero();
  Sum image = Sum::Zero();
  for (std::size_t i = 0; i < scores.weight.size(); ++i) {
    if (scores.weight[i] > 0) {
      const Jacobian J = jacobian_of(scores, i);
      const Sum square = scores.weight[i] * J * J.head<6>().transpose();
      const auto row = static_cast<float>(view.points.pixel[i].y);
      points += below_middle(row, inverse_height) * square;
      image += below_middle(scores.v[i], inverse_height) * square;
    }
  }
  return {points.cast<double>(), image.cast<double>()};
}

ReadoutMoments ReadoutMoments::of(const PointView& view, const PointTerms& scores,
                                  const Vector6d& points_twist, const Vector6d& image_twist) {
  using Twist = Eigen::Matrix<float, 6, 1>;
  const float inverse_height = 1 / static_cast<float>(view.image.camera.height);
  const Twist points = points_twist.cast<float>();
  const Twist image = image_twist.cast<float>();
  float square = 0;
  float by_residual = 0;
  Jacobian coupling = Jacobian::Zero();
  for (std::size_t i = 0; i < scores.weight.size(); ++i) {
    if (scores.weight[i] > 0) {
      const Jacobian J = jacobian_of(scores, i);
      const auto row = static_cast<float>(view.points.pixel[i].y);
      const float q = below_middle(row, inverse_height) * J.head<6>().dot(points) -
                      below_middle(scores.v[i], inverse_height) * J.head<6>().dot(image);
      const float weighted = scores.weight[i] * q;
      square += weighted * q;
      by_residual += weighted * scores.residual[i];
      coupling += weighted * J;
    }
  }
  return {square, by_residual, coupling.cast<double>()};
}

}  // namespace vo
