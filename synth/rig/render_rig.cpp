#include "synth/rig/render_rig.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "synth/camera/renderers_over_time.h"
#include "synth/rendering/renderer.h"
#include "synth/rig/projector_pattern.h"
#include "synth/scene/scene.h"
#include "synth/sequence/depth_coverage.h"
#include "synth/sequence/frame_share.h"
#include "synth/sequence/share_renderer.h"
#include "synth/truth/imu.h"
#include "synth/truth/truth_channels.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/hashing/content_hash.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/output_folders/staged_folder.h"
#include "vo/rigs/rig_file.h"

namespace synth {
namespace {

namespace fs = std::filesystem;

/// Puts files of a folder into one within another.
void move_into(const std::string& folder, std::vector<vo::NamedBytes>& files) {
  for (vo::NamedBytes& file : files) {
    file.name.insert(0, folder + "/");
  }
}

/// Returns what the rig's IMU measures, and the true states of the body.
vo::ImuRecord measure_body(const RigJob& job) {
  const SequenceRecipe& recipe = job.body.recipe;
  const TimeSpan span{recipe.truth.front().timestamp, recipe.truth.back().timestamp};
  const CameraPath body = path_of(recipe);
  const CameraPath imu = [&](double time) { return body(time) * job.rig.T_body_imu; };
  vo::ImuRecord record = measure_imu(imu, span, recipe.channels.imu);
  for (vo::BodyState& state : record.states) {
    state.T_world_body = body(state.timestamp);
    state.velocity = path_motion(body, span, state.timestamp).velocity;
  }
  return record;
}

/// Returns the name of the copy of a projector's pattern in the folder of a rig.
std::string pattern_file(const vo::RigProjector& projector) {
  return vo::concat("projector_", projector.name, ".png");
}

/// Returns the files of the body, which belong to no camera.
std::vector<vo::NamedBytes> body_files(const RigJob& job) {
  const SequenceRecipe& recipe = job.body.recipe;
  std::vector<vo::NamedBytes> files = {{"groundtruth.txt", vo::format_trajectory(recipe.truth)}};
  if (recipe.channels.has(TruthChannel::imu)) {
    const std::vector<vo::NamedBytes> imu = encode_imu(measure_body(job));
    files.insert(files.end(), imu.begin(), imu.end());
  }
  for (const vo::RigProjector& projector : job.rig.projectors) {
    if (projector.has_file()) {
      files.push_back({pattern_file(projector), pattern_bytes(projector)});
    }
  }
  return files;
}

/// A rig, its cameras' jobs, and the folder that they fill: for each pose of the body a part for
/// each camera, in the rig's order.
struct RigPlan {
  std::vector<RenderJob> jobs;
  vo::StagedContent content;
};

/// Returns rig.toml as it is written: each sensor with all its options, and by which inputs one
/// folder is told from another, in a comment.
vo::NamedBytes marker_of(const RigJob& job, const std::vector<RenderJob>& jobs) {
  vo::Rig rig = job.rig;
  vo::ContentHash manifests;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    SensorOptions sensor = jobs[i].recipe.sensor;
    rig.cameras[i].sensor.clear();
    for (const vo::Field& field : vo::fields_of(sensor)) {
      rig.cameras[i].sensor.push_back({field.key, field.get(), field.type, ""});
    }
    manifests.add(sequence_manifest(jobs[i]).bytes);
  }
  for (vo::RigProjector& projector : rig.projectors) {
    projector.pattern = projector.has_file() ? pattern_file(projector) : projector.pattern;
  }
  return {vo::kRigFile,
          vo::concat("# Hash of the cameras' sequence.toml, which say what they were made of: ",
                     manifests.hex(), "\n", vo::format_rig(rig))};
}

RigPlan plan_of(const RigJob& job) {
  RigPlan plan{camera_jobs(job), {}};
  plan.content.marker = marker_of(job, plan.jobs);
  plan.content.rest = body_files(job);
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    const std::string& name = job.rig.cameras[i].name;
    std::vector<vo::NamedBytes> files = sequence_files(plan.jobs[i]);
    files.push_back(sequence_manifest(plan.jobs[i]));
    move_into(name, files);
    plan.content.rest.insert(plan.content.rest.end(), files.begin(), files.end());
    plan.content.folders.push_back(name);
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

/// Makes the frames of all cameras, which see the scene by the same renderers.
class RigFrames {
 public:
  RigFrames(const vo::Rig& rig, const std::vector<RenderJob>& jobs) : rig_(rig) {
    const Scene& scene = jobs.front().scene.scene();
    const auto renderers =
        std::make_shared<const RenderersOverTime>(scene, jobs.front().recipe.render);
    for (const RenderJob& job : jobs) {
      generators_.push_back(frame_generator(job, renderers));
    }
  }

  MadeFrame make(std::size_t part) const {
    const std::size_t camera = part % generators_.size();
    MadeFrame frame = generators_[camera]->make(part / generators_.size());
    move_into(rig_.cameras[camera].name, frame.files);
    return frame;
  }

 private:
  const vo::Rig& rig_;
  std::vector<std::unique_ptr<const FrameGenerator>> generators_;
};

ShareJob share_of_rig(const RigJob& job, const RigPlan& plan) {
  ShareJob share{plan.content, {}, [&]() -> PartMaker {
                   const auto frames = std::make_shared<const RigFrames>(job.rig, plan.jobs);
                   return [frames](std::size_t part) { return frames->make(part); };
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

RenderOutcome render_rig(const RigJob& job, const fs::path& folder, const vo::OutputPolicy& policy,
                         const vo::Progress& progress, const MadeFrameObserver& observe) {
  frames_of(job.body.share, job.body.recipe.truth.size());  // throws before any work
  const RigPlan plan = plan_of(job);
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
  outcome.notes = notes_on_rig(job);
  add_coverage(job, plan, outcome);
  return outcome;
}

std::vector<std::string> notes_on_rig(const RigJob& job) {
  std::vector<std::string> notes = notes_on_scene(job.body);
  const RenderOptions& render = job.body.recipe.render;
  if (job.rig.projectors.empty() || render.mode == RenderMode::depth) {
    return notes;
  }
  const bool has_infrared = std::any_of(
      job.rig.cameras.begin(), job.rig.cameras.end(),
      [](const vo::RigCamera& camera) { return camera.spectrum == vo::Spectrum::infrared; });
  if (!has_infrared) {
    notes.emplace_back("projectors are left out: no camera of the rig has spectrum = \"infrared\"");
  } else if (render.kind == RendererKind::rasterizer || render.mode == RenderMode::unlit) {
    notes.emplace_back(
        "projectors are left out; the ray tracer draws their light in the modes direct and path");
  }
  return notes;
}

RenderPlan plan_rig(const RigJob& job, const fs::path& folder) {
  const double loading_s = load_scene(job.body.scene);
  const RigPlan rig = plan_of(job);
  RenderPlan plan = plan_share(share_of_rig(job, rig), folder);
  plan.processor_s += loading_s;
  return plan;
}

}  // namespace synth
