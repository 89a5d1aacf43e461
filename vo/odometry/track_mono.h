#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/odometry/track_sequence.h"

namespace vo {

/// Where a monocular run reads.
struct MonoInput {
  std::filesystem::path folder;
  std::optional<RgbdCamera> camera;   ///< the folder's otherwise
  double max_time_difference = 0.02;  ///< s, of colour and depth of the first frame
  std::filesystem::path depth_file;   ///< of bootstrap=file: 16-bit PNG, or .npy in metres
};

struct MonoSequenceResult {
  std::vector<MonoResult> frames;
  std::vector<StageTimes> times;
  Trajectory trajectory;

  double tracked_fraction() const;
  std::size_t keyframes() const;
};

/// Told after each frame.
using MonoObserver = std::function<void(const RgbdFrame& frame, const MonoOdometry& odometry,
                                        const MonoResult& result)>;

/// Images in order, from wherever they come; nothing after the last.
struct MonoImages {
  PinholeCamera camera;
  SE3 T_world_first;
  std::size_t size = 0;
  std::function<std::optional<RgbdFrame>()> next;  ///< only the first needs depth
};

/// The frames from which a monocular run starts: colour alone, but for the first where the
/// bootstrap asks for depth. Throws vo::Error where that depth cannot be used.
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

/// From the origin.
MonoSequenceResult track_mono_sequence(const MonoInput& input, const MonoOptions& options,
                                       const MonoObserver& observe, const Progress& progress);

/// CSV with one line per frame: the state, the parallax meter, the map and the alignment.
std::string format_mono_log(const std::vector<MonoResult>& frames);

}  // namespace vo
