#include "tools/bench/summary.h"

#include <algorithm>
#include <vector>

#include "vo/core/error.h"
#include "vo/evaluation/evaluate.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {
namespace {

/// Returns a value of each frame after the warm-up: the median over the repeats.
template <typename Value>
std::vector<double> per_frame(const RaceResult& result, const RaceOptions& options, Value value) {
  std::vector<double> values;
  const std::size_t frames = result.samples.front().size();
  for (auto i = static_cast<std::size_t>(options.warm_up); i < frames; ++i) {
    std::vector<double> repeats;
    for (const std::vector<FrameSample>& samples : result.samples) {
      repeats.push_back(value(samples[i]));
    }
    values.push_back(vo::percentile(repeats, 0.5));
  }
  return values;
}

template <typename Value>
double median(const RaceResult& result, const RaceOptions& options, Value value) {
  return vo::percentile(per_frame(result, options, value), 0.5);
}

StageCosts median_stages(const RaceResult& result, const RaceOptions& options) {
  const auto stage = [&](double StageCosts::*member) {
    return median(result, options, [&](const FrameSample& s) { return s.costs.*member; });
  };
  return {.pyramid_ms = stage(&StageCosts::pyramid_ms),
          .edges_ms = stage(&StageCosts::edges_ms),
          .alignment_ms = stage(&StageCosts::alignment_ms),
          .map_ms = stage(&StageCosts::map_ms)};
}

/// Returns the errors; empty where truth or estimate are too short to be compared.
std::optional<Accuracy> accuracy(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  try {
    const vo::TrajectoryErrors errors = vo::evaluate(truth, estimate);
    return Accuracy{.rpe_translation_rmse_m = errors.rpe.translation.rmse,
                    .rpe_rotation_rmse_deg = errors.rpe.rotation_deg.rmse,
                    .ate_rmse_m = errors.ate.rmse};
  } catch (const vo::Error&) {
    return std::nullopt;
  }
}

std::optional<double> map_mib(const FrameSample& sample) {
  constexpr double kBytesPerMib = 1 << 20;
  return sample.map_bytes ? std::optional(static_cast<double>(*sample.map_bytes) / kBytesPerMib)
                          : std::nullopt;
}

}  // namespace

Summary summarize(const RaceResult& result, const Frames& input, const RaceOptions& options) {
  const std::vector<double> totals =
      per_frame(result, options, [](const FrameSample& s) { return s.costs.total_ms(); });
  const std::vector<FrameSample>& samples = result.samples.front();
  const vo::Trajectory estimate = trajectory(result, input);
  const auto keyframes = std::count_if(samples.begin(), samples.end(),
                                       [](const FrameSample& s) { return s.is_keyframe; });
  return {.name = result.name,
          .median_ms = vo::percentile(totals, 0.5),
          .p90_ms = vo::percentile(totals, 0.9),
          .cpu_ms = median(result, options, [](const FrameSample& s) { return s.cpu_ms; }),
          .stages = median_stages(result, options),
          .points = median(result, options,
                           [](const FrameSample& s) { return static_cast<double>(s.points); }),
          .keyframes = static_cast<std::size_t>(keyframes),
          .tracked_fraction =
              static_cast<double>(estimate.size()) / static_cast<double>(samples.size()),
          .map_mib = map_mib(samples.back()),
          .accuracy = accuracy(input.truth, estimate)};
}

}  // namespace tools
