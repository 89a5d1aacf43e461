#include "tools/datasets/sequence_jobs.h"

#include "tools/scenario/run_scenario.h"

namespace tools {

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

const synth::RenderJob& SequenceJobs::job(std::size_t sequence) {
  if (last_ == sequence) {
    return job_;
  }
  last_.reset();
  const DatasetSequence& wanted = spec_.sequences.at(sequence);
  job_ = render_job(wanted.scenario, scene_of(wanted));
  job_.recipe.channels.channels = spec_.channels();
  job_.recipe.float_depth = spec_.options.float_depth ? vo::FloatDepth::npy : vo::FloatDepth::none;
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
