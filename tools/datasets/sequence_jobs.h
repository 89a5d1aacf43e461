#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "synth/path_planning/path_options.h"
#include "synth/rig/camera_jobs.h"
#include "synth/sequence/render_sequence.h"
#include "tools/datasets/spec.h"
#include "vo/files/output.h"

namespace tools {

/// What is rendered of a sequence: the jobs of its cameras.
struct SequenceJob {
  std::optional<synth::RigJob> rig;       ///< none: there is one camera
  std::vector<synth::RenderJob> cameras;  ///< in the rig's order, one at least

  std::size_t frame_count() const { return cameras.front().recipe.truth.size(); }  ///< of a camera

  /// Returns the name of a camera of the rig, empty where there is none.
  std::string camera_name(std::size_t camera) const;

  /// Returns the files of the sequence's folder that belong to no frame.
  std::vector<vo::NamedBytes> files() const;
};

/// The render jobs of a data set's sequences. A scene is read once for all sequences that show it,
/// and a path planned once for all parts of its sequence that are asked for in a row. The spec must
/// outlive it.
class SequenceJobs {
 public:
  explicit SequenceJobs(const DatasetSpec& spec) : spec_(spec) {}

  /// Returns the job of a sequence, valid until that of another is asked for. Throws vo::Error
  /// where the scene or the path is unusable.
  const SequenceJob& job(std::size_t sequence);

 private:
  const synth::SceneFile& scene_of(const DatasetSequence& sequence);

  const DatasetSpec& spec_;
  std::map<std::string, synth::SceneFile> scenes_;  ///< by name; the one in use alone
  std::optional<std::size_t> last_;                 ///< sequence of `job_`
  SequenceJob job_;
};

/// Returns the path of a camera and the times of its frames.
synth::TimedPath timed_path(const synth::RenderJob& job);

}  // namespace tools
