#include "synth/sensor/noise_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace synth {
namespace {

constexpr int kTerms = 3;
using Design = Eigen::Matrix<double, Eigen::Dynamic, kTerms>;
using Terms = Eigen::Matrix<double, kTerms, 1>;

double rounding_variance(double step) {
  return step * step / 12;
}

double squared(double value) {
  return value * value;
}

/// Returns the non-negative x with the least |A x - 1|: the best of all choices of positive terms.
Terms non_negative_fit(const Design& A) {
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(A.rows());
  Terms best = Terms::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (unsigned chosen = 1; chosen < (1U << kTerms); ++chosen) {
    Design part = A;
    for (int term = 0; term < kTerms; ++term) {
      part.col(term) *= (chosen >> static_cast<unsigned>(term)) % 2U;
    }
    const Terms x = part.completeOrthogonalDecomposition().solve(ones);
    const double error = (part * x - ones).squaredNorm();
    if (x.minCoeff() >= 0 && error < least) {
      least = error;
      best = x;
    }
  }
  return best;
}

}  // namespace

double depth_variance(const SensorOptions& sensor, const vo::RgbdCameraModel& camera,
                      double depth) {
  const DepthSensorOptions& options = sensor.depth;
  double variance = squared(axial_sigma(options.axial, depth, 0));
  if (options.normal.sigma > 0) {
    const double focal_px = camera.model.pinhole_for("sensor.depth.normal").fx;
    variance += squared(options.normal.sigma * depth / focal_px);
  }
  variance += rounding_variance(options.step);
  variance += rounding_variance(1 / camera.depth_units_per_m);
  const DisparityNoise& disparity = options.disparity;
  if (disparity.focal_baseline > 0) {
    variance += squared(depth * depth / disparity.focal_baseline) *
                    (squared(disparity.sigma) + rounding_variance(disparity.step)) +
                rounding_variance(disparity.depth_step);
  }
  return variance;
}

vo::DepthNoise depth_noise_model(const SensorOptions& sensor, const vo::RgbdCameraModel& camera) {
  constexpr double kNearest = 0.5;   // m
  constexpr double kFarthest = 5.0;  // m
  constexpr int kDepths = 46;
  Design A(kDepths, kTerms);
  for (int i = 0; i < kDepths; ++i) {
    const double z = kNearest + (kFarthest - kNearest) * i / (kDepths - 1);
    A.row(i) = Eigen::RowVector3d(1, z * z, z * z * z * z) / depth_variance(sensor, camera, z);
  }
  const Terms scale = A.colwise().maxCoeff();
  const Design scaled = A.array().rowwise() / scale.transpose().array();
  const Terms variances = non_negative_fit(scaled).array() / scale.array();
  return {.constant = std::sqrt(variances[0]),
          .linear = std::sqrt(variances[1]),
          .quadratic = std::sqrt(variances[2])};
}

}  // namespace synth
