#include "vo/mapping/fuse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vo {
namespace {

constexpr float kMaxInliers = 5;        // limit of the successes that can outweigh failures
constexpr float kFailureGrowth = 1.1F;  // factor of the variance at each failure
constexpr float kLeastShare = 0.3F;     // least share of an inverse depth after one update
constexpr double kBetaPrior = 10;       // a and b before the first measurement
constexpr double kMinInlierShare = 0.4;
constexpr double kMinSigma = 0.001;  // least relative standard deviation of an inverse depth
constexpr int kMaxFailures = 3;      // surplus of failures over successes that deletes

float least_variance(float inverse_depth) {
  const float sigma = static_cast<float>(kMinSigma) * inverse_depth;
  return sigma * sigma;
}

/// Updates inverse depth d and offset by Kalman's equations: the observation is d + k offset.
void fuse_gaussian(const Observation& observation, std::size_t i, Hypotheses& hypotheses) {
  const Innovation step = innovation(observation, i, hypotheses);
  const float k = observation.offset_slope;
  const float depth_share = hypotheses.variance[i] + k * hypotheses.offset_covariance[i];
  const float offset_share = hypotheses.offset_covariance[i] + k * hypotheses.offset_variance[i];
  hypotheses.inverse_depth[i] =
      std::max(hypotheses.inverse_depth[i] + depth_share / step.variance * step.difference,
               kLeastShare * hypotheses.inverse_depth[i]);
  hypotheses.offset[i] += offset_share / step.variance * step.difference;
  hypotheses.variance[i] =
      std::max(hypotheses.variance[i] - depth_share * depth_share / step.variance,
               least_variance(hypotheses.inverse_depth[i]));
  hypotheses.offset_covariance[i] -= depth_share * offset_share / step.variance;
  hypotheses.offset_variance[i] =
      std::max(hypotheses.offset_variance[i] - offset_share * offset_share / step.variance, 0.0F);
}

/// Updates the Gaussian-Beta filter, which has no second state: the offset counts as noise.
void fuse_beta(const Observation& observation, const DepthMapOptions& options, std::size_t i,
               Hypotheses& hypotheses) {
  const BetaFilter filter =
      updated({hypotheses.inverse_depth[i], hypotheses.variance[i],
               kBetaPrior + hypotheses.inliers[i], kBetaPrior + hypotheses.outliers[i]},
              observation.inverse_depth,
              observation.variance + observation.offset_slope * observation.offset_slope,
              1 / options.min_depth);
  hypotheses.inverse_depth[i] = static_cast<float>(filter.mean);
  hypotheses.variance[i] =
      std::max(static_cast<float>(filter.variance), least_variance(hypotheses.inverse_depth[i]));
  hypotheses.inliers[i] = static_cast<float>(filter.a - kBetaPrior);
  hypotheses.outliers[i] = static_cast<float>(filter.b - kBetaPrior);
}

bool is_hopeless(const DepthMapOptions& options, float inliers, float outliers) {
  if (options.fusion == Fusion::gaussian_beta) {
    return kBetaPrior + inliers < kMinInlierShare * (2 * kBetaPrior + inliers + outliers);
  }
  return outliers - inliers >= static_cast<float>(kMaxFailures);
}

double normal_density(double x, double mean, double variance) {
  return std::exp(-0.5 * (x - mean) * (x - mean) / variance) /
         std::sqrt(2 * std::numbers::pi * variance);
}

}  // namespace

BetaFilter updated(const BetaFilter& prior, double x, double tau2, double range) {
  const double a = prior.a;
  const double b = prior.b;
  const double s2 = 1 / (1 / prior.variance + 1 / tau2);
  const double m = s2 * (prior.mean / prior.variance + x / tau2);
  double c1 = a / (a + b) * normal_density(x, prior.mean, prior.variance + tau2);
  double c2 = b / (a + b) / range;
  const double sum = c1 + c2;
  c1 /= sum;
  c2 /= sum;
  const double f = c1 * (a + 1) / (a + b + 1) + c2 * a / (a + b + 1);
  const double e = c1 * (a + 1) * (a + 2) / ((a + b + 1) * (a + b + 2)) +
                   c2 * a * (a + 1) / ((a + b + 1) * (a + b + 2));
  BetaFilter posterior;
  posterior.mean = c1 * m + c2 * prior.mean;
  posterior.variance = c1 * (s2 + m * m) + c2 * (prior.variance + prior.mean * prior.mean) -
                       posterior.mean * posterior.mean;
  posterior.a = (e - f) / (f - e / f);
  posterior.b = posterior.a * (1 - f) / f;
  return posterior;
}

Innovation innovation(const Observation& observation, std::size_t i, const Hypotheses& hypotheses) {
  const float k = observation.offset_slope;
  return {observation.inverse_depth - hypotheses.inverse_depth[i] - k * hypotheses.offset[i],
          hypotheses.variance[i] + 2 * k * hypotheses.offset_covariance[i] +
              k * k * hypotheses.offset_variance[i] + observation.variance};
}

void fuse(const Observation& observation, const DepthMapOptions& options, std::size_t i,
          Hypotheses& hypotheses) {
  if (hypotheses.state[i] == DepthState::none) {
    const float k = observation.offset_slope;
    hypotheses.set(i, observation.inverse_depth, observation.variance + k * k);
    hypotheses.offset_covariance[i] = -k;
    hypotheses.state[i] = DepthState::tentative;
    hypotheses.inliers[i] = 1;
    return;
  }
  if (options.fusion == Fusion::gaussian_beta) {
    fuse_beta(observation, options, i, hypotheses);
  } else {
    fuse_gaussian(observation, i, hypotheses);
    hypotheses.inliers[i] = std::min(hypotheses.inliers[i] + 1, kMaxInliers);
    hypotheses.outliers[i] = std::max(hypotheses.outliers[i] - 1, 0.0F);
  }
  hypotheses.state[i] = DepthState::known;
}

void count_failure(const DepthMapOptions& options, float guess, std::size_t i,
                   Hypotheses& hypotheses) {
  hypotheses.outliers[i] += 1;
  hypotheses.variance[i] *= kFailureGrowth;
  if (hypotheses.state[i] == DepthState::tentative ||
      is_hopeless(options, hypotheses.inliers[i], hypotheses.outliers[i])) {
    hypotheses.forget(i, guess);
  }
}

}  // namespace vo
