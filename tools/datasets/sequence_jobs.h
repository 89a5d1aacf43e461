#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "synth/path_planning/path_options.h"
#include "synth/sequence/render_sequence.h"
#include "tools/datasets/spec.h"

namespace tools {

/// The render jobs of a data set's sequences. A scene is read once for all sequences that show it,
/// and a path planned once for all parts of its sequence that are asked for in a row. The spec must
/// outlive it.
class SequenceJobs {
 public:
  explicit SequenceJobs(const DatasetSpec& spec) : spec_(spec) {}

  /// Returns the job of a sequence, valid until that of another is asked for. Throws vo::Error
  /// where the scene or the path is unusable.
  const synth::RenderJob& job(std::size_t sequence);

 private:
  const synth::SceneFile& scene_of(const DatasetSequence& sequence);

  const DatasetSpec& spec_;
  std::map<std::string, synth::SceneFile> scenes_;  ///< by name; the one in use alone
  std::optional<std::size_t> last_;                 ///< sequence of `job_`
  synth::RenderJob job_;
};

/// Returns the path of a job and the times of its frames.
synth::TimedPath timed_path(const synth::RenderJob& job);

}  // namespace tools
