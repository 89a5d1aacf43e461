#include "vo/segmentation/static_evidence.h"

#include <algorithm>
#include <cmath>

#include "vo/residuals/point_sampler.h"
#include "vo/residuals/warp.h"

namespace vo {
namespace {

/// Evidence of a depth that is nearer than what the other frame saw.
constexpr float kSeenThrough = -4;

/// Returns the standard deviation of the residuals of static points, intensity: the alignment's
/// scale, unless that is so large that it must be what moves that disagrees.
float noise_of(const ResidualModel& model) {
  constexpr float kMost = 12.0F / 255;
  return std::min(static_cast<float>(model.scale), kMost);
}

/// Returns the standard deviation of the points' intensities.
float contrast_of(const EdgePointLevel& points) {
  double sum = 0;
  double squares = 0;
  for (const double value : points.intensity) {
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(std::max<std::size_t>(points.size(), 1));
  return static_cast<float>(std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n))));
}

/// The logarithm of the ratio of two t-distributions' densities: of the images' noise, and of the
/// contrast between places that have nothing to do with each other. It is bounded below.
class IntensityEvidence {
 public:
  IntensityEvidence(float noise, float contrast)
      : by_noise_(1 / (kStudentFreedom * noise * noise)),
        by_contrast_(1 / (kStudentFreedom * std::max(4 * noise * noise, contrast * contrast))),
        at_zero_(0.5F * std::log(by_noise_ / by_contrast_)) {}

  float of(float residual) const {
    constexpr float kMostAgainst = -2;
    constexpr float kPower = 0.5F * (kStudentFreedom + 1);
    const float square = residual * residual;
    const float ratio = (1 + square * by_noise_) / (1 + square * by_contrast_);
    return std::max(kMostAgainst, at_zero_ - kPower * natural_log(ratio));
  }

 private:
  float by_noise_, by_contrast_;  // 1 / (degrees of freedom times the squared scale)
  float at_zero_;
};

/// Returns the finest level with at most one depth across a tile.
std::size_t depth_level(const FramePyramid& frame) {
  std::size_t level = 0;
  while (level + 1 < frame.levels.size() &&
         frame.levels[level].camera.width > ViewTiles::kColumns) {
    ++level;
  }
  return level;
}

/// Returns the nearest depth of nine pixels, or 0 where one has none.
float nearest_around(const DepthImage& depth, int u, int v) {
  float nearest = depth(v, u);
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      nearest = std::min(nearest, depth(v + dv, u + du));
    }
  }
  return has_depth(nearest) ? nearest : 0;
}

/// Adds evidence to the tiles of a frame's depths that are nearer than where another frame saw
/// through.
void add_seen_through(const PyramidLevel& own, const PyramidLevel& other, const SE3& T_other_own,
                      float weight, TileEvidence& sum) {
  constexpr float kThrough = 0.92F;  // share of the depth measured there
  const cv::Rect inside(1, 1, other.depth.cols - 2, other.depth.rows - 2);
  const Warp<float> warp(other.camera, T_other_own);
  const ViewTiles grid(own.camera);
  for (int v = 0; v < own.depth.rows; ++v) {
    for (int u = 0; u < own.depth.cols; ++u) {
      const float z = own.depth(v, u);
      if (!has_depth(z)) {
        continue;
      }
      const cv::Vec2f& ray = own.rays(v, u);
      const WarpedPoint<float> point = warp_point<float>(warp, {z * ray[0], z * ray[1], z});
      if (!is_in_view(point, other.camera)) {
        continue;
      }
      const cv::Point pixel(cvRound(point.u), cvRound(point.v));
      if (inside.contains(pixel) &&
          point.p_cur.z() < kThrough * nearest_around(other.depth, pixel.x, pixel.y)) {
        sum[grid.of({u, v})] += weight * kSeenThrough;
      }
    }
  }
}

/// Weighs each tile with its neighbours by 1/4, 1/2, 1/4 in both directions.
TileEvidence smoothed(const TileEvidence& evidence) {
  TileEvidence result{};
  for (std::size_t tile = 0; tile < evidence.size(); ++tile) {
    ViewTiles::for_each_around(tile, [&](std::size_t near) {
      const bool same_column = near % ViewTiles::kColumns == tile % ViewTiles::kColumns;
      const bool same_row = near / ViewTiles::kColumns == tile / ViewTiles::kColumns;
      result[tile] += (same_column ? 0.5F : 0.25F) * (same_row ? 0.5F : 0.25F) * evidence[near];
    });
  }
  return result;
}

}  // namespace

TileMask moving_tiles(const TileEvidence& log_odds) {
  constexpr float kClearlyMoving = -2;
  TileMask moving;
  for (std::size_t tile = 0; tile < log_odds.size(); ++tile) {
    moving[tile] = log_odds[tile] < kClearlyMoving;
  }
  return moving;
}

StaticEvidence::StaticEvidence(std::span<const AlignReference> references,
                               const AlignCurrent& current, const AlignResult& aligned,
                               const AlignOptions& options, ComparedReferences compared) {
  const std::size_t last = references.size() - 1;
  const auto is_compared = [=](std::size_t r) {
    return compared == ComparedReferences::all || r == 0 || r == last;
  };
  std::size_t count = 0;
  for (std::size_t r = 0; r < references.size(); ++r) {
    references_.push_back({});
    count += is_compared(r) ? 1 : 0;
  }
  weight_ = 1 / static_cast<float>(count);
  const JointProblem problem(references, current, /*level=*/0, options);
  for (std::size_t pair = 0; pair < problem.models().size(); ++pair) {
    if (is_compared(pair % references.size())) {
      add_intensities(problem.pair_view(pair, aligned.T_cur_ref), pair, aligned.models[pair]);
    }
  }
  for (std::size_t r = 0; r < references.size(); ++r) {
    if (is_compared(r)) {
      add_depths(current.frame, *references[r].frame, r,
                 aligned.T_cur_ref * references[r].T_first_ref);
    }
  }
  for (TileEvidence& evidence : references_) {
    evidence = smoothed(evidence);
  }
  current_ = smoothed(current_);
}

void StaticEvidence::add_intensities(const PointView& view, std::size_t pair,
                                     const ResidualModel& model) {
  constexpr float kIndependence = 0.5F;  // neighbouring points err alike
  const IntensityEvidence evidence(noise_of(model), contrast_of(view.points));
  const auto gain = static_cast<float>(model.brightness.gain);
  const auto offset = static_cast<float>(model.brightness.offset);
  const float weight = kIndependence * weight_;
  const bool is_forward = pair < references_.size();
  const ViewTiles grid(view.image.camera);
  PointSampler sampler(view, available_instruction_set(), static_cast<float>(kVisibleDepthRatio));
  for (std::size_t block = 0; block < sampler.blocks(); ++block) {
    const PointSamples seen = sampler.sample(block);
    const std::size_t first = PointSampler::first_of(block);
    for (std::size_t i = 0; i < seen.intensity.size(); ++i) {
      if (std::isnan(seen.intensity[i])) {
        continue;
      }
      const float value =
          evidence.of(seen.intensity[i] - (gain * view.points.intensity[first + i] + offset));
      const std::size_t own = grid.of(view.points.pixel[first + i]);
      if (is_forward) {
        references_[pair][own] += value;
      }
      current_[is_forward ? grid.of(seen.u[i], seen.v[i]) : own] += weight * value;
    }
  }
}

void StaticEvidence::add_depths(const FramePyramid& current, const FramePyramid& reference,
                                std::size_t r, const SE3& T_cur_ref) {
  const std::size_t level = depth_level(current);
  const PyramidLevel& now = current.levels[level];
  const PyramidLevel& then = reference.levels[level];
  if (!now.depth.empty() && !then.depth.empty()) {
    add_seen_through(then, now, T_cur_ref, 1, references_[r]);
    add_seen_through(now, then, T_cur_ref.inverse(), weight_, current_);
  }
}

}  // namespace vo
