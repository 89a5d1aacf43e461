#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/edges/edges.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/image/pyramid.h"
#include "vo/tracking/tracker_options.h"
#include "vo/tracking/tracking_result.h"

namespace vo {

class Tracker;

/// Names of sets of option values; no code path asks which preset it was.
enum class TrackerPreset {
  paper,         ///< Christensen & Hebert, "Edge-Direct Visual Odometry", frame to frame
  authors,       ///< the authors' released code where it deviates from the paper
  best_measured  ///< the values that measured best
};

constexpr auto enum_names(TrackerPreset) {
  return std::array{std::pair{TrackerPreset::paper, "paper"},
                    std::pair{TrackerPreset::authors, "authors"},
                    std::pair{TrackerPreset::best_measured, "default"}};
}

TrackerOptions preset_options(TrackerPreset preset);

/// Returns the camera that the warp uses. Throws Error where images are too small to be tracked.
PinholeCamera tracked_camera(const PinholeCamera& camera, LensModel lens);

/// Wall-clock times of one frame's stages, for diagnosis; no result depends on them.
struct StageTimes {
  double pyramid_ms = 0;
  double edges_ms = 0;
  double alignment_ms = 0;  ///< includes the choice of the points
  double mapping_ms = 0;    ///< monocular only

  double total_ms() const { return pyramid_ms + edges_ms + alignment_ms + mapping_ms; }
};

/// RGB-D edge-direct odometry: one call per frame.
class RgbdOdometry {
 public:
  /// Starts at T_world_first. Without options they are those of the best preset, which the program
  /// has by default, too; TrackerOptions{} are the paper's. Throws Error for options that cannot be
  /// used.
  explicit RgbdOdometry(
      const PinholeCamera& camera,
      const TrackerOptions& options = preset_options(TrackerPreset::best_measured),
      const SE3& T_world_first = {});
  RgbdOdometry(RgbdOdometry&& other) noexcept;
  RgbdOdometry& operator=(RgbdOdometry&& other) noexcept;
  ~RgbdOdometry();

  /// Tracks a frame. Throws Error when image or depth have another size than the camera.
  TrackingResult track(const RgbdFrame& frame);

  const Trajectory& trajectory() const { return trajectory_; }    ///< frames that are not lost
  const StageTimes& stage_times() const { return stage_times_; }  ///< last frame's times
  const FramePyramid& current() const { return current_; }        ///< last frame's pyramid
  const Tracker& tracker() const { return *tracker_; }

 private:
  DepthImage depth_at_image_time(const RgbdFrame& frame);

  PinholeCamera camera_;
  TrackerOptions options_;
  PyramidBuilder pyramid_builder_;
  EdgeFinder edge_finder_;
  std::unique_ptr<Tracker> tracker_;
  FramePyramid current_;
  DepthImage moved_depth_;  ///< last frame's depth, where it was moved to the image's time
  Trajectory trajectory_;
  StageTimes stage_times_;
};

}  // namespace vo
