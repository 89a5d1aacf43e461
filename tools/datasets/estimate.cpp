#include "tools/datasets/estimate.h"

#include <algorithm>
#include <vector>

#include "synth/rig/render_rig.h"
#include "synth/sequence/render_plan.h"

namespace tools {
namespace {

/// Returns the sequences that are made, evenly thinned.
std::vector<std::size_t> sampled(const DatasetPlan& plan) {
  constexpr std::size_t kMost = 8;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < plan.frames.size(); ++i) {
    if (plan.frames[i] > 0) {
      all.push_back(i);
    }
  }
  std::vector<std::size_t> some;
  const std::size_t count = std::min(all.size(), kMost);
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(all[i * all.size() / count]);
  }
  return some;
}

}  // namespace

DatasetEstimate estimate_dataset(const DatasetSpec& spec, const DatasetPlan& plan,
                                 const vo::Progress& progress) {
  DatasetEstimate estimate;
  SequenceJobs jobs(spec);
  const std::vector<std::size_t> sequences = sampled(plan);
  std::size_t frames = 0;
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    const SequenceJob& job = jobs.job(sequences[i]);
    const synth::RenderPlan one = job.rig ? synth::plan_rig(*job.rig, job.cameras, {})
                                          : synth::plan_sequence(job.cameras.front(), {});
    estimate.files += one.files;
    estimate.bytes += one.bytes;
    estimate.processor_s += one.processor_s;
    estimate.measured += one.measured;
    frames += one.frames;
    if (progress) {
      progress(i + 1, sequences.size());
    }
  }
  const double scale =
      frames == 0 ? 0 : static_cast<double>(plan.frame_count()) / static_cast<double>(frames);
  estimate.files = static_cast<std::size_t>(scale * static_cast<double>(estimate.files));
  estimate.bytes *= scale;
  estimate.processor_s *= scale;
  return estimate;
}

}  // namespace tools
