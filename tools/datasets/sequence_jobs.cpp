#include "tools/datasets/sequence_jobs.h"

#include <utility>

#include "synth/rig/rig_files.h"
#include "tools/scenario/run_scenario.h"

namespace tools {

std::string SequenceJob::camera_name(std::size_t camera) const {
  return rig ? rig->rig.cameras[camera].name : "";
}

std::vector<vo::NamedBytes> SequenceJob::files() const {
  std::vector<vo::NamedBytes> files =
      rig ? synth::rig_files(*rig, cameras) : synth::sequence_files(cameras.front());
  files.push_back(rig ? synth::rig_manifest(*rig, cameras)
                      : synth::sequence_manifest(cameras.front()));
  return files;
}

const synth::SceneFile& SequenceJobs::scene_of(const DatasetSequence& sequence) {
  const auto open = scenes_.find(sequence.scene);
  if (open != scenes_.end()) {
    return open->second;
  }
  scenes_.clear();  // sequences are sorted by scene: the one before is not needed again
  synth::GltfOptions parts = sequence.scenario.resolved_parts();
  parts.needed = synth::needed_textures(
      {.render = sequence.scenario.render, .channels = {.channels = spec_.channels()}});
  return scenes_
      .emplace(sequence.scene,
               synth::SceneFile(sequence.scenario.scene_file(), parts, sequence.scenario.actors))
      .first->second;
}

const SequenceJob& SequenceJobs::job(std::size_t sequence) {
  if (last_ == sequence) {
    return job_;
  }
  last_.reset();
  const DatasetSequence& wanted = spec_.sequences.at(sequence);
  synth::RenderJob job = render_job(wanted.scenario, scene_of(wanted));
  job.recipe.channels.channels = spec_.channels();
  job.recipe.float_depth = spec_.options.float_depth ? vo::FloatDepth::npy : vo::FloatDepth::none;
  if (spec_.rig) {
    job_.rig = synth::RigJob{*spec_.rig, std::move(job)};
    job_.cameras = synth::camera_jobs(*job_.rig);
  } else {
    job_.cameras = {std::move(job)};
  }
  last_ = sequence;
  return job_;
}

synth::TimedPath timed_path(const synth::RenderJob& job) {
  synth::TimedPath timed{synth::path_of(job.recipe), {}};
  for (const vo::StampedPose& pose : job.recipe.truth) {
    timed.times.push_back(pose.timestamp);
  }
  return timed;
}

}  // namespace tools
