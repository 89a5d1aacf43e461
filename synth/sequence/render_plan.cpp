#include "synth/sequence/render_plan.h"

#include <algorithm>
#include <vector>

#include "vo/core/processor_time.h"

namespace synth {
namespace {

constexpr std::size_t kMeasured = 3;  // number of frames to render, spread over the missing ones
constexpr double kSecondsPerMs = 1e-3;

/// Estimates processor time and bytes of rendering `parts` from the middle ones of equal shares.
void measure(const ShareJob& job, const std::vector<std::size_t>& parts, RenderPlan& plan) {
  const double start_ms = vo::processor_ms();
  const PartMaker make = job.prepare();
  const double ready_ms = vo::processor_ms();
  plan.measured = std::min(kMeasured, parts.size());
  double bytes = 0;
  for (std::size_t i = 0; i < plan.measured; ++i) {
    const std::size_t part = parts[(2 * i + 1) * parts.size() / (2 * plan.measured)];
    for (const vo::NamedBytes& file : make(part).files) {
      bytes += static_cast<double>(file.bytes.size());
    }
  }
  const double scale = static_cast<double>(parts.size()) / static_cast<double>(plan.measured);
  plan.bytes = scale * bytes;
  plan.processor_s =
      kSecondsPerMs * ((ready_ms - start_ms) + scale * (vo::processor_ms() - ready_ms));
}

}  // namespace

double load_scene(const SceneFile& scene) {
  const double start_ms = vo::processor_ms();
  scene.scene();
  return kSecondsPerMs * (vo::processor_ms() - start_ms);
}

RenderPlan plan_share(const ShareJob& job, const std::filesystem::path& folder) {
  const std::vector<std::size_t> missing = parts_to_render(job, folder);
  RenderPlan plan{.frames = job.parts.size(), .there = job.parts.size() - missing.size()};
  for (const std::size_t part : missing) {
    plan.files += job.content.parts[part].files.size();
  }
  if (!missing.empty()) {
    measure(job, missing, plan);
  }
  return plan;
}

RenderPlan plan_sequence(const RenderJob& job, const std::filesystem::path& folder) {
  const double loading_s = load_scene(job.scene);
  const vo::StagedContent content = sequence_content(job);
  RenderPlan plan = plan_share(share_job(job, content), folder);
  plan.processor_s += loading_s;
  return plan;
}

}  // namespace synth
