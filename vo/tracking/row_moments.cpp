#include "vo/tracking/row_moments.h"

namespace vo {
namespace {

using Jacobian = Eigen::Matrix<float, kPassParameters, 1>;
using Sum = Eigen::Matrix<float, kPassParameters, 6>;

Jacobian jacobian_of(const PointScores& scores, std::size_t i) {
  Jacobian J;
  for (std::size_t p = 0; p < kPassParameters; ++p) {
    J[static_cast<Eigen::Index>(p)] = scores.J[p][i];
  }
  return J;
}

}  // namespace

RowMoments RowMoments::of(const PointView& view, const PointScores& scores) {
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

}  // namespace vo
