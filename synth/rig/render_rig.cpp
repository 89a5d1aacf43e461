#include "synth/rig/render_rig.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "synth/camera/make_renderer.h"
#include "synth/rendering/renderer.h"
#include "synth/rig/rig_files.h"
#include "synth/sequence/depth_coverage.h"
#include "synth/sequence/frame_share.h"
#include "synth/sequence/share_renderer.h"
#include "vo/core/error.h"
#include "vo/output_folders/staged_folder.h"

namespace synth {
namespace {

namespace fs = std::filesystem;

/// The jobs of a rig's cameras, and the folder that they fill: for each pose of the body a part for
/// each camera, in the rig's order.
struct RigPlan {
  const std::vector<RenderJob>& jobs;
  vo::StagedContent content;
};

RigPlan plan_of(const RigJob& job, const std::vector<RenderJob>& cameras) {
  RigPlan plan{cameras, {}};
  plan.content.marker = rig_manifest(job, plan.jobs);
  plan.content.rest = rig_files(job, plan.jobs);
  for (const vo::RigCamera& camera : job.rig.cameras) {
    plan.content.folders.push_back(camera.name);
  }
  for (std::size_t frame = 0; frame < job.body.recipe.truth.size(); ++frame) {
    for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
      const std::string& name = job.rig.cameras[i].name;
      vo::FolderPart part = frame_part(plan.jobs[i].recipe, frame);
      part.name = vo::concat(name, "-", part.name);
      for (std::string& file : part.files) {
        file.insert(0, name + "/");
      }
      plan.content.parts.push_back(std::move(part));
    }
  }
  return plan;
}

ShareJob share_of_rig(const RigJob& job, const RigPlan& plan) {
  ShareJob share{plan.content, {}, [&]() -> PartMaker {
                   const auto frames = std::make_shared<const RigFrames>(plan.jobs);
                   return [&job, frames](std::size_t part) {
                     const std::size_t cameras = job.rig.cameras.size();
                     MadeFrame frame = frames->make(part % cameras, part / cameras);
                     move_into(job.rig.cameras[part % cameras].name, frame.files);
                     return frame;
                   };
                 }};
  for (const std::size_t frame : frames_of(job.body.share, job.body.recipe.truth.size())) {
    for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
      share.parts.push_back(frame * plan.jobs.size() + i);
    }
  }
  return share;
}

/// Adds to the outcome how much of the images has depth: the mean over the cameras, and warnings.
void add_coverage(const RigJob& job, const RigPlan& plan, RenderOutcome& outcome) {
  const std::vector<std::size_t> all = frames_of({}, job.body.recipe.truth.size());
  double sum = 0;
  std::size_t cameras = 0;
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    const std::string& name = job.rig.cameras[i].name;
    const SequenceRecipe& recipe = plan.jobs[i].recipe;
    const std::optional<double> coverage = depth_coverage(recipe, all, outcome.folder / name);
    if (coverage) {
      sum += *coverage;
      ++cameras;
      const std::string warning = warn_of_coverage(job.body.scene.scene(), recipe, *coverage);
      if (!warning.empty()) {
        outcome.warning +=
            vo::concat(outcome.warning.empty() ? "" : "; ", "camera '", name, "': ", warning);
      }
    }
  }
  if (cameras > 0) {
    outcome.depth_coverage = sum / static_cast<double>(cameras);
  }
}

}  // namespace

RenderOutcome render_rig(const RigJob& job, const std::vector<RenderJob>& cameras,
                         const fs::path& folder, const vo::OutputPolicy& policy,
                         const vo::Progress& progress, const MadeFrameObserver& observe) {
  frames_of(job.body.share, job.body.recipe.truth.size());  // throws before any work
  require_drawable(job.body.scene.scene(), job.body.recipe.render);
  const RigPlan plan = plan_of(job, cameras);
  MadeFrameObserver first_camera;
  if (observe) {
    first_camera = [&](std::size_t part, const MadeFrame& frame) {
      if (part % plan.jobs.size() == 0) {
        observe(part / plan.jobs.size(), frame);
      }
    };
  }
  RenderOutcome outcome =
      render_share(share_of_rig(job, plan), folder, policy, {progress, first_camera});
  outcome.notes = notes_on_rig(job, cameras);
  for (std::string& note : notes_on_stamps(job, cameras)) {
    outcome.notes.push_back(std::move(note));
  }
  add_coverage(job, plan, outcome);
  return outcome;
}

std::vector<std::string> notes_on_rig(const RigJob& job, const std::vector<RenderJob>& cameras) {
  std::vector<std::string> notes;
  for (const RenderJob& camera : cameras) {
    for (std::string& note : notes_on_scene(camera)) {
      if (std::find(notes.begin(), notes.end(), note) == notes.end()) {
        notes.push_back(std::move(note));
      }
    }
  }
  const RenderOptions& render = job.body.recipe.render;
  if (job.rig.projectors.empty() || render.mode == RenderMode::depth) {
    return notes;
  }
  if (!vo::has_infrared_camera(job.rig)) {
    notes.emplace_back("projectors are left out: no camera of the rig has spectrum = \"infrared\"");
  } else if (!render.draws_projectors()) {
    notes.emplace_back(
        "projectors are left out; the ray tracer draws their light in the modes direct and path");
  }
  return notes;
}

std::vector<std::string> notes_on_stamps(const RigJob& job, const std::vector<RenderJob>& cameras) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const double first = cameras[i].recipe.truth.front().timestamp;
    if (first < 0) {
      notes.push_back(vo::concat("camera '", job.rig.cameras[i].name, "': its first frame is at ",
                                 first,
                                 " s; MCAP holds no stamps below 0, and EuRoC's images of "
                                 "such have names that begin with -"));
    }
  }
  return notes;
}

RenderPlan plan_rig(const RigJob& job, const std::vector<RenderJob>& cameras,
                    const fs::path& folder) {
  const double loading_s = load_scene(job.body.scene);
  const RigPlan rig = plan_of(job, cameras);
  RenderPlan plan = plan_share(share_of_rig(job, rig), folder, rig.jobs.size());
  plan.processor_s += loading_s;
  return plan;
}

}  // namespace synth
