#include "synth/rig/rig_files.h"

#include <algorithm>

#include "synth/camera/renderers_over_time.h"
#include "synth/rig/projector_pattern.h"
#include "synth/scene/scene.h"
#include "synth/truth/imu.h"
#include "synth/truth/truth_channels.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/hashing/content_hash.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/rigs/rig_file.h"

namespace synth {
namespace {

/// Returns the time in which a camera is exposed, from its first row to its last.
TimeSpan exposed_span(const SequenceRecipe& camera) {
  const Shutter& shutter = camera.sensor.shutter;
  const int height = camera.camera.model.height();
  return {camera.truth.front().timestamp + shutter.time_in_row(0, 0, height),
          camera.truth.back().timestamp + shutter.time_in_row(height - 1, 1, height)};
}

/// Returns the time that the rig's IMU must cover: `body`, that of the body's poses, and where a
/// camera takes its frames at other times, also that in which the cameras are exposed.
TimeSpan covered_span(const RigJob& job, const std::vector<RenderJob>& jobs, const TimeSpan& body) {
  const std::vector<vo::RigCamera>& cameras = job.rig.cameras;
  if (std::all_of(cameras.begin(), cameras.end(),
                  [](const vo::RigCamera& camera) { return camera.time_offset == 0; })) {
    return body;
  }
  TimeSpan covered = body;
  for (const RenderJob& camera : jobs) {
    const TimeSpan exposed = exposed_span(camera.recipe);
    covered = {std::min(covered.begin, exposed.begin), std::max(covered.end, exposed.end)};
  }
  return covered;
}

/// Returns what the rig's IMU measures, and the true states of the body.
vo::ImuRecord measure_body(const RigJob& job, const std::vector<RenderJob>& jobs) {
  const SequenceRecipe& recipe = job.body.recipe;
  const TimeSpan span{recipe.truth.front().timestamp, recipe.truth.back().timestamp};
  const CameraPath body = path_of(recipe);
  const CameraPath imu = [&](double time) { return body(time) * job.rig.T_body_imu; };
  vo::ImuRecord record = measure_imu(imu, span, recipe.channels.imu, covered_span(job, jobs, span));
  const TimeSpan around{record.states.front().timestamp, record.states.back().timestamp};
  for (vo::BodyState& state : record.states) {
    state.T_world_body = body(state.timestamp);
    state.velocity = path_motion(body, span, around, state.timestamp).velocity;
  }
  return record;
}

/// Returns the name of the copy of a projector's pattern in the folder of a rig.
std::string pattern_file(const vo::RigProjector& projector) {
  return vo::concat("projector_", projector.name, ".png");
}

/// Returns the files of the body, which belong to no camera.
std::vector<vo::NamedBytes> body_files(const RigJob& job, const std::vector<RenderJob>& jobs) {
  const SequenceRecipe& recipe = job.body.recipe;
  std::vector<vo::NamedBytes> files = {{"groundtruth.txt", vo::format_trajectory(recipe.truth)}};
  if (recipe.channels.has(TruthChannel::imu)) {
    const std::vector<vo::NamedBytes> imu = encode_imu(measure_body(job, jobs));
    files.insert(files.end(), imu.begin(), imu.end());
  }
  for (const vo::RigProjector& projector : job.rig.projectors) {
    if (projector.has_file()) {
      files.push_back({pattern_file(projector), pattern_bytes(projector)});
    }
  }
  return files;
}

}  // namespace

void move_into(const std::string& folder, std::vector<vo::NamedBytes>& files) {
  for (vo::NamedBytes& file : files) {
    file.name.insert(0, folder + "/");
  }
}

RigFrames::RigFrames(const std::vector<RenderJob>& jobs) {
  const Scene& scene = jobs.front().scene.scene();
  const auto renderers =
      std::make_shared<const RenderersOverTime>(scene, jobs.front().recipe.render);
  for (const RenderJob& job : jobs) {
    generators_.push_back(frame_generator(job, renderers));
  }
}

MadeFrame RigFrames::make(std::size_t camera, std::size_t frame) const {
  return generators_[camera]->make(frame);
}

std::vector<vo::NamedBytes> rig_files(const RigJob& job, const std::vector<RenderJob>& jobs) {
  std::vector<vo::NamedBytes> all = body_files(job, jobs);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    std::vector<vo::NamedBytes> files = sequence_files(jobs[i]);
    files.push_back(sequence_manifest(jobs[i]));
    move_into(job.rig.cameras[i].name, files);
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

vo::NamedBytes rig_manifest(const RigJob& job, const std::vector<RenderJob>& jobs) {
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

}  // namespace synth
