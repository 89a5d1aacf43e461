#include "vo/segmentation/static_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "vo/core/instruction_set.h"
#include "vo/residuals/point_sampler.h"
#include "vo/segmentation/free_space.h"
#include "vo/segmentation/tiles_where.h"

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
  IntensityEvidence(const ResidualModel& model, float contrast)
      : gain_(static_cast<float>(model.brightness.gain)),
        offset_(static_cast<float>(model.brightness.offset)) {
    const float noise = noise_of(model);
    by_noise_ = 1 / (kStudentFreedom * noise * noise);
    by_contrast_ = 1 / (kStudentFreedom * std::max(4 * noise * noise, contrast * contrast));
    at_zero_ = 0.5F * std::log(by_noise_ / by_contrast_);
  }

  /// Computes the evidence of intensities that are seen where points of the given own intensities
  /// are looked up.
  void weigh(std::span<const float> seen, const float* own, float* evidence) const {
    const bool is_baseline = available_instruction_set() == InstructionSet::baseline;
    (is_baseline ? weigh_baseline : weigh_avx2)(*this, seen, own, evidence);
  }

 private:
  EDVO_INLINE float of(float residual) const {
    constexpr float kMostAgainst = -2;
    constexpr float kPower = 0.5F * (kStudentFreedom + 1);
    const float square = residual * residual;
    const float ratio = (1 + square * by_noise_) / (1 + square * by_contrast_);
    return std::max(kMostAgainst, at_zero_ - kPower * natural_log(ratio));
  }

  EDVO_INLINE void weigh_all(std::span<const float> seen, const float* __restrict own,
                             float* __restrict evidence) const {
    for (std::size_t i = 0; i < seen.size(); ++i) {
      evidence[i] = of(seen[i] - (gain_ * own[i] + offset_));
    }
  }

  static void weigh_baseline(const IntensityEvidence& self, std::span<const float> seen,
                             const float* own, float* evidence) {
    self.weigh_all(seen, own, evidence);
  }

  EDVO_TARGET_AVX2 static void weigh_avx2(const IntensityEvidence& self,
                                          std::span<const float> seen, const float* own,
                                          float* evidence) {
    self.weigh_all(seen, own, evidence);
  }

  float gain_, offset_;           // of the points' intensities, to those seen
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

/// Adds a row of tiles, weighted, to another.
void add_row(float weight, const float* row, float* __restrict sum) {
  for (std::size_t column = 0; column < ViewTiles::kColumns; ++column) {
    sum[column] += weight * row[column];
  }
}

/// Weighs each tile with its neighbours by 1/4, 1/2, 1/4 in both directions.
TileEvidence smoothed(const TileEvidence& evidence) {
  constexpr std::size_t kWidth = ViewTiles::kColumns;
  constexpr std::size_t kHeight = ViewTiles::kRows;
  constexpr std::array<float, 3> kWeights{0.25F, 0.5F, 0.25F};
  std::array<std::array<float, kWidth + 2>, kHeight + 2> padded{};
  for (std::size_t row = 0; row < kHeight; ++row) {
    std::copy_n(evidence.begin() + static_cast<std::ptrdiff_t>(row * kWidth), kWidth,
                padded[row + 1].begin() + 1);
  }
  TileEvidence result{};
  for (std::size_t row = 0; row < kHeight; ++row) {
    for (std::size_t dv = 0; dv < kWeights.size(); ++dv) {
      for (std::size_t du = 0; du < kWeights.size(); ++du) {
        add_row(kWeights[dv] * kWeights[du], padded[row + dv].data() + du,
                result.data() + row * kWidth);
      }
    }
  }
  return result;
}

}  // namespace

TileMask moving_tiles(const TileEvidence& log_odds) {
  constexpr float kClearlyMoving = -2;
  return tiles_where([&](std::size_t tile) { return log_odds[tile] < kClearlyMoving; });
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
      references_[r] = smoothed(references_[r]);
    }
  }
  current_ = smoothed(current_);
}

void StaticEvidence::add_intensities(const PointView& view, std::size_t pair,
                                     const ResidualModel& model) {
  constexpr float kIndependence = 0.5F;  // neighbouring points err alike
  const IntensityEvidence evidence(model, contrast_of(view.points));
  const float weight = kIndependence * weight_;
  const bool is_forward = pair < references_.size();
  const ViewTiles grid(view.image.camera);
  PointSampler sampler(view, available_instruction_set(), static_cast<float>(kVisibleDepthRatio));
  std::array<float, PointSampler::kPointsPerBlock> values;
  for (std::size_t block = 0; block < sampler.blocks(); ++block) {
    const PointSamples seen = sampler.sample(block);
    const std::size_t first = PointSampler::first_of(block);
    evidence.weigh(seen.intensity, view.points.intensity.data() + first, values.data());
    for (std::size_t i = 0; i < seen.intensity.size(); ++i) {
      if (std::isnan(seen.intensity[i])) {
        continue;
      }
      const std::size_t own = grid.of(view.points.pixel[first + i]);
      if (is_forward) {
        references_[pair][own] += values[i];
      }
      current_[is_forward ? grid.of(seen.u[i], seen.v[i]) : own] += weight * values[i];
    }
  }
}

void StaticEvidence::add_depths(const FramePyramid& current, const FramePyramid& reference,
                                std::size_t r, const SE3& T_cur_ref) {
  const std::size_t level = depth_level(current);
  const PyramidLevel& now = current.levels[level];
  const PyramidLevel& then = reference.levels[level];
  if (!now.depth.empty() && !then.depth.empty()) {
    add_seen_through(then, now, T_cur_ref, kSeenThrough, references_[r]);
    add_seen_through(now, then, T_cur_ref.inverse(), weight_ * kSeenThrough, current_);
  }
}

}  // namespace vo
