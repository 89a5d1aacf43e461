#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace vo {

/// The files of a monocular run.
struct MonoInput {
  std::filesystem::path folder;
  std::optional<RgbdCamera> camera;   ///< overrides the folder's camera
  double max_time_difference = 0.02;  ///< s, between colour and depth of the first frame
  std::filesystem::path depth_file;   ///< 16-bit PNG, or .npy in metres, for bootstrap=file
  SequenceTopics topics;              ///< of a recording
};

struct MonoSequenceResult {
  std::vector<MonoResult> frames;
  std::vector<StageTimes> times;
  Trajectory trajectory;
  std::size_t oriented_poses = 0;         ///< poses of the trajectory whose rotation alone is known
  std::size_t scale_uncertain_poses = 0;  ///< poses of the trajectory in a map of uncertain scale
  std::vector<std::string> sequence_notes;  ///< as SequenceReader::notes has them

  SequenceResult tracking() const;  ///< what the RGB-D odometry would return, too
  double mapping_ms() const;        ///< median over the frames in which the map was observed
  std::string why_no_pose() const;  ///< sentence on a run without any pose: how often which reason
};

/// Called after each frame.
using MonoObserver = std::function<void(const RgbdFrame& frame, const MonoOdometry& odometry,
                                        const MonoResult& result)>;

/// A source of images in order; `next` returns nothing after the last.
struct MonoImages {
  PinholeCamera camera;
  SE3 T_world_first;
  std::size_t size = 0;
  std::function<std::optional<RgbdFrame>()> next;  ///< only the first frame needs depth
};

/// The frames of a monocular run: colour alone, except that the first has depth where the bootstrap
/// asks for it. Throws vo::Error where that depth cannot be used.
class MonoFrames {
 public:
  MonoFrames(const MonoInput& input, MonoBootstrap bootstrap);

  const SequenceReader& sequence() const { return sequence_; }
  std::size_t size() const { return sequence_.size() - first_index_; }
  std::optional<RgbdFrame> next();

 private:
  SequenceReader sequence_;
  DepthImage first_depth_;
  std::size_t first_index_ = 0;
  std::size_t next_index_ = 0;
};

MonoSequenceResult track_mono_images(const MonoImages& images, const MonoOptions& options,
                                     const MonoObserver& observe, const Progress& progress);

/// Tracks a folder's images, with the first frame at the origin.
MonoSequenceResult track_mono_sequence(const MonoInput& input, const MonoOptions& options,
                                       const MonoObserver& observe, const Progress& progress);

/// Returns CSV with one line per frame: state, parallax measurement, map and alignment.
std::string format_mono_log(const std::vector<MonoResult>& frames);

}  // namespace vo
