#include "synth/sequence/render_plan.h"

#include <algorithm>
#include <vector>

#include "vo/core/processor_time.h"

namespace synth {
namespace {

constexpr std::size_t kMeasured = 3;  // number of frames to render, spread over the missing ones
constexpr double kSecondsPerMs = 1e-3;

/// Estimates processor time and bytes of rendering `frames` from the middle ones of equal parts.
void measure(const Scene& scene, const RenderJob& job, const std::vector<std::size_t>& frames,
             RenderPlan& plan) {
  const double start_ms = vo::processor_ms();
  const FrameGenerator generator(scene, job.recipe);
  const double ready_ms = vo::processor_ms();
  plan.measured = std::min(kMeasured, frames.size());
  double bytes = 0;
  for (std::size_t i = 0; i < plan.measured; ++i) {
    const std::size_t frame = frames[(2 * i + 1) * frames.size() / (2 * plan.measured)];
    for (const vo::NamedBytes& file : generator.make(frame).files) {
      bytes += static_cast<double>(file.bytes.size());
    }
  }
  const double scale = static_cast<double>(frames.size()) / static_cast<double>(plan.measured);
  plan.bytes = scale * bytes;
  plan.processor_s =
      kSecondsPerMs * ((ready_ms - start_ms) + scale * (vo::processor_ms() - ready_ms));
}

}  // namespace

RenderPlan plan_sequence(const RenderJob& job, const std::filesystem::path& folder) {
  const double start_ms = vo::processor_ms();
  const Scene& scene = job.scene.scene();
  const double loading_s = kSecondsPerMs * (vo::processor_ms() - start_ms);
  const std::size_t frames = frames_of(job.share, job.recipe.truth.size()).size();
  const std::vector<std::size_t> missing = frames_to_render(job, scene, folder);
  RenderPlan plan{.frames = frames, .there = frames - missing.size()};
  for (const std::size_t frame : missing) {
    plan.files += frame_files(job.recipe, frame).size();
  }
  if (!missing.empty()) {
    measure(scene, job, missing, plan);
  }
  plan.processor_s += loading_s;
  return plan;
}

}  // namespace synth
