#include "synth/sequence/render_plan.h"

#include <algorithm>
#include <vector>

#include "vo/core/processor_time.h"

namespace synth {
namespace {

constexpr std::size_t kMeasured = 3;  // least number of frames to render, if so many are missing
constexpr double kSecondsPerMs = 1e-3;

/// Returns some of the parts, spread over all, of each kind equally many.
std::vector<std::size_t> measured_parts(const std::vector<std::size_t>& parts, std::size_t kinds) {
  const std::size_t wanted = kinds * ((kMeasured + kinds - 1) / kinds);
  const std::size_t count = std::min(wanted, parts.size());
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t middle = (2 * i + 1) * parts.size() / (2 * count);  // of equal shares
    const std::size_t of_kind = middle / kinds * kinds + i % kinds;
    some.push_back(parts[std::min(of_kind, parts.size() - 1)]);
  }
  return some;
}

/// Estimates processor time and bytes of rendering `parts` from some of them.
void measure(const ShareJob& job, const std::vector<std::size_t>& parts, std::size_t kinds,
             RenderPlan& plan) {
  const double start_ms = vo::processor_ms();
  const PartMaker make = job.prepare();
  const double ready_ms = vo::processor_ms();
  const std::vector<std::size_t> measured = measured_parts(parts, kinds);
  plan.measured = measured.size();
  double bytes = 0;
  for (const std::size_t part : measured) {
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

RenderPlan plan_share(const ShareJob& job, const std::filesystem::path& folder, std::size_t kinds) {
  const std::vector<std::size_t> missing = parts_to_render(job, folder);
  RenderPlan plan{.frames = job.parts.size(), .there = job.parts.size() - missing.size()};
  for (const std::size_t part : missing) {
    plan.files += job.content.parts[part].files.size();
  }
  if (!missing.empty()) {
    measure(job, missing, kinds, plan);
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
