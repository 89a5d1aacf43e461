#include "tools/depth/depth_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/depth/true_depth.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {
namespace {

constexpr double kOutlier = 0.1;

/// Returns depth_step where the true depth varies by more than 5 % within two pixels.
EdgeKind kind_at(const vo::DepthImage& depth, cv::Point pixel) {
  constexpr int kRadius = 2;
  constexpr float kStep = 1.05F;
  float nearest = 1e9F;
  float farthest = 0;
  for (int v = std::max(0, pixel.y - kRadius); v <= std::min(depth.rows - 1, pixel.y + kRadius);
       ++v) {
    for (int u = std::max(0, pixel.x - kRadius); u <= std::min(depth.cols - 1, pixel.x + kRadius);
         ++u) {
      if (vo::has_depth(depth(v, u))) {
        nearest = std::min(nearest, depth(v, u));
        farthest = std::max(farthest, depth(v, u));
      }
    }
  }
  return farthest > kStep * nearest ? EdgeKind::depth_step : EdgeKind::surface;
}

/// Returns all causes within one pixel, because an edge lies between two pixels.
std::uint8_t causes_at(const synth::EdgeLabels& causes, cv::Point pixel) {
  const cv::Rect window =
      cv::Rect(pixel - cv::Point(1, 1), cv::Size(3, 3)) & cv::Rect(cv::Point(0, 0), causes.size());
  std::uint8_t found = 0;
  for (int v = window.y; v < window.y + window.height; ++v) {
    for (int u = window.x; u < window.x + window.width; ++u) {
      found = static_cast<std::uint8_t>(found | causes(v, u));
    }
  }
  return found;
}

template <typename Predicate>
DepthErrors summarize_if(const std::vector<DepthSample>& samples, Predicate chosen) {
  std::vector<double> errors;
  double squares = 0;
  double inliers = 0;
  for (const DepthSample& sample : samples) {
    if (chosen(sample)) {
      errors.push_back(std::abs(sample.ratio - 1));
      if (errors.back() <= kOutlier) {
        squares += sample.normalized_error * sample.normalized_error;
        inliers += 1;
      }
    }
  }
  const auto count = static_cast<double>(errors.size());
  if (errors.empty()) {
    return {0, NAN, NAN, NAN, NAN};
  }
  return {errors.size(), 100 * vo::percentile(errors, 0.5), 100 * vo::percentile(errors, 0.9),
          100 * (count - inliers) / count, squares / inliers};
}

double median_ratio(const std::vector<DepthSample>& samples) {
  std::vector<double> ratios;
  for (const DepthSample& sample : samples) {
    if (sample.is_confident) {
      ratios.push_back(sample.ratio);
    }
  }
  return ratios.empty() ? 1 : vo::percentile(ratios, 0.5);
}

/// Returns which of two inverse depths is nearer to the estimate; a first one of 0 is none.
double nearer(double first, double second, double estimate) {
  const bool is_second = first == 0 || std::abs(second - estimate) < std::abs(first - estimate);
  return is_second ? second : first;
}

}  // namespace

double nearest_true_inverse_depth(const vo::DepthImage& depth, cv::Point pixel, double estimate) {
  double nearest = 0;
  for (int v = std::max(0, pixel.y - 1); v <= std::min(depth.rows - 1, pixel.y + 1); ++v) {
    for (int u = std::max(0, pixel.x - 1); u <= std::min(depth.cols - 1, pixel.x + 1); ++u) {
      if (vo::has_depth(depth(v, u))) {
        nearest = nearer(nearest, 1 / static_cast<double>(depth(v, u)), estimate);
      }
    }
  }
  return nearest;
}

std::vector<DepthSample> depth_samples(const vo::DepthMap& map, const TrueView& truth,
                                       const vo::FrameRelation& relation, double scale) {
  const vo::Hypotheses& hypotheses = map.hypotheses();
  const vo::PyramidLevel& level = map.host().levels.front();
  const vo::StereoPair pair(level, level, relation);
  std::vector<DepthSample> samples;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const double estimate = hypotheses.smoothed[i] / scale;
    const double expected = nearest_true_inverse_depth(truth.depth, hypotheses.pixel[i], estimate);
    if (hypotheses.state[i] == vo::DepthState::none || expected == 0) {
      continue;
    }
    const double sigma =
        std::hypot(std::sqrt(hypotheses.smoothed_variance[i]) / scale, truth.depth_noise);
    const double cos2 = vo::epipolar_cos2(pair, hypotheses.pixel[i], hypotheses.gradient[i]);
    samples.push_back({estimate / expected, (estimate - expected) / sigma,
                       std::acos(std::sqrt(std::min(cos2, 1.0))) * 180 / std::numbers::pi,
                       hypotheses.is_confident(i, vo::kConfidentSigma),
                       kind_at(truth.depth, hypotheses.pixel[i]),
                       causes_at(truth.causes, hypotheses.pixel[i])});
  }
  return samples;
}

MapErrors map_errors(const vo::DepthMap& map, const TrueView& truth,
                     const vo::FrameRelation& relation, double host_scale) {
  std::vector<DepthSample> samples = depth_samples(map, truth, relation, 1);
  MapErrors errors;
  errors.scale = median_ratio(samples);
  if (host_scale != 1) {
    samples = depth_samples(map, truth, relation, host_scale == 0 ? errors.scale : host_scale);
  }
  errors.all = summarize_if(samples, [](const DepthSample&) { return true; });
  errors.confident = summarize_if(samples, [](const DepthSample& s) { return s.is_confident; });
  errors.surface = summarize_if(
      samples, [](const DepthSample& s) { return s.is_confident && s.kind == EdgeKind::surface; });
  errors.depth_step = summarize_if(samples, [](const DepthSample& s) {
    return s.is_confident && s.kind == EdgeKind::depth_step;
  });
  for (std::size_t cause = 0; cause < errors.by_cause.size(); ++cause) {
    const std::uint8_t bit = synth::bit(static_cast<synth::EdgeCause>(cause));
    errors.by_cause.at(cause) = summarize_if(
        samples, [bit](const DepthSample& s) { return s.is_confident && (s.causes & bit) != 0; });
  }
  errors.without_cause = summarize_if(samples, [&](const DepthSample& s) {
    return s.is_confident && s.causes == 0 && !truth.causes.empty();
  });
  for (std::size_t bin = 0; bin < errors.by_angle.size(); ++bin) {
    const double low = 30 * static_cast<double>(bin);
    errors.by_angle.at(bin) = summarize_if(samples, [low](const DepthSample& s) {
      return s.is_confident && s.angle_deg >= low && (s.angle_deg < low + 30 || low == 60);
    });
  }
  errors.density_percent = 100 * static_cast<double>(map.confident()) /
                           std::max(1.0, static_cast<double>(map.hypotheses().size()));
  return errors;
}

}  // namespace tools
