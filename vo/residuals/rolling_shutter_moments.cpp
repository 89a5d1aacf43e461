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

/// Tells how far past the middle row and the middle column the points of a view are, as a share of
/// the image's size: at their own pixels and where they are looked up.
class LinePlaces {
 public:
  LinePlaces(const PointView& view, const PointTerms& scores)
      : view_(view),
        scores_(scores),
        inverse_width_(1 / static_cast<float>(view.image.camera.width)),
        inverse_height_(1 / static_cast<float>(view.image.camera.height)) {}

  float of_point(std::size_t i, ReadoutAxis axis) const {
    const cv::Point& pixel = view_.points.pixel[i];
    return axis == ReadoutAxis::rows ? past_middle(static_cast<float>(pixel.y), inverse_height_)
                                     : past_middle(static_cast<float>(pixel.x), inverse_width_);
  }
  float in_image(std::size_t i, ReadoutAxis axis) const {
    return axis == ReadoutAxis::rows ? past_middle(scores_.v[i], inverse_height_)
                                     : past_middle(scores_.u[i], inverse_width_);
  }

 private:
  const PointView& view_;
  const PointTerms& scores_;
  float inverse_width_, inverse_height_;
};

}  // namespace

RollingShutterMoments RollingShutterMoments::of(const PointView& view, const PointTerms& scores,
                                                ReadoutAxis axis) {
  const LinePlaces places(view, scores);
  Sum points = Sum::Zero();
  Sum image = Sum::Zero();
  for (std::size_t i = 0; i < scores.weight.size(); ++i) {
    if (scores.weight[i] > 0) {
      const Jacobian J = jacobian_of(scores, i);
      const Sum square = scores.weight[i] * J * J.head<6>().transpose();
      points += places.of_point(i, axis) * square;
      image += places.in_image(i, axis) * square;
    }
  }
  return {points.cast<double>(), image.cast<double>()};
}

ReadoutMoments ReadoutMoments::of(const PointView& view, const PointTerms& scores,
                                  const Vector6d& points_twist, const Vector6d& image_twist) {
  using Twist = Eigen::Matrix<float, 6, 1>;
  const LinePlaces places(view, scores);
  const Twist points = points_twist.cast<float>();
  const Twist image = image_twist.cast<float>();
  Eigen::Matrix2f square = Eigen::Matrix2f::Zero();
  Eigen::Vector2f by_residual = Eigen::Vector2f::Zero();
  Eigen::Matrix<float, kPassParameters, 2> coupling =
      Eigen::Matrix<float, kPassParameters, 2>::Zero();
  for (std::size_t i = 0; i < scores.weight.size(); ++i) {
    if (scores.weight[i] > 0) {
      const Jacobian J = jacobian_of(scores, i);
      const float by_points = J.head<6>().dot(points);
      const float by_image = J.head<6>().dot(image);
      Eigen::Vector2f q;
      for (const ReadoutAxis axis : {ReadoutAxis::rows, ReadoutAxis::columns}) {
        q[static_cast<int>(axis)] =
            places.of_point(i, axis) * by_points - places.in_image(i, axis) * by_image;
      }
      const Eigen::Vector2f weighted = scores.weight[i] * q;
      square += weighted * q.transpose();
      by_residual += weighted * scores.residual[i];
      coupling += J * weighted.transpose();
    }
  }
  return {square.cast<double>(), by_residual.cast<double>(), coupling.cast<double>()};
}

}  // namespace vo
