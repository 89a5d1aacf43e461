#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "synth/rig/camera_jobs.h"
#include "synth/sequence/generate.h"
#include "synth/sequence/render_sequence.h"
#include "vo/files/output.h"

namespace synth {

/// Puts files of a folder into one of this name within another.
void move_into(const std::string& folder, std::vector<vo::NamedBytes>& files);

/// Makes the frames of several cameras, from any thread. The cameras see one scene by the same
/// renderers, which saves building what rays are traced in once more for each.
class RigFrames {
 public:
  /// `jobs` are those of the cameras, in one scene with equal options of rendering, one at least;
  /// they must outlive it.
  explicit RigFrames(const std::vector<RenderJob>& jobs);

  /// Returns a camera's frame, its files named as within the camera's own folder.
  MadeFrame make(std::size_t camera, std::size_t frame) const;

 private:
  std::vector<std::unique_ptr<const FrameGenerator>> generators_;
};

/// Returns the files of a rig's folder that belong to no frame, but for rig.toml: those of the
/// body, groundtruth.txt (T_world_body), the IMU's if the channel `imu` is asked for, patterns of
/// projectors that come from files, and those of each camera, in its folder. `jobs` are the rig's
/// `camera_jobs`.
std::vector<vo::NamedBytes> rig_files(const RigJob& job, const std::vector<RenderJob>& jobs);

/// Returns rig.toml as it is written: each sensor with all its options, and by which inputs one
/// folder is told from another, in a comment.
vo::NamedBytes rig_manifest(const RigJob& job, const std::vector<RenderJob>& jobs);

}  // namespace synth
