#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/odometry/rgbd_odometry.h"

namespace vo {

/// The results of tracking a whole sequence, frame by frame.
struct SequenceResult {
  std::vector<TrackingResult> frames;
  std::vector<StageTimes> times;  ///< for diagnosis, differ from run to run
  std::vector<float> depths_m;    ///< median depth of each frame that has any
  Trajectory trajectory;          ///< frames that are not lost

  double tracked_fraction() const;  ///< share of all frames; the first counts as tracked
  std::size_t keyframes() const;
  std::size_t uncertain() const;   ///< frames whose pose must not be relied on
  std::size_t beginnings() const;  ///< frames that a map began with
  double moving_fraction() const;  ///< mean share of the view that moves by itself

  /// Returns how many frames are lost or uncertain for each reason.
  std::map<TrackingReason, std::size_t> reasons() const;

  /// Returns the median of the frames' median depths, m, or 0 without any.
  double typical_depth_m() const;
};

/// Called after each frame, before the next one is read; for pictures.
using FrameObserver =
    std::function<void(const RgbdFrame& frame, const FramePyramid& pyramid, const Tracker& tracker,
                       const TrackingResult& result, const StageTimes& times)>;

SequenceResult track_sequence(const SequenceReader& sequence, const TrackerOptions& options,
                              const SE3& T_world_first, const FrameObserver& observe,
                              const Progress& progress);

/// Returns what a user must know of an RGB-D trajectory to use it: how many frames are lost or
/// uncertain and why, and depths that no depth camera measures. Empty where all is well.
std::string note_on(const SequenceResult& result);

/// Returns the nearest-rank percentile of a fraction 0..1, or 0 without values.
double percentile(std::vector<double> values, double fraction);

/// Median and 90th percentile of the frames' total times and medians of their stages' times, ms.
struct TimeSummary {
  double median_ms = 0;
  double p90_ms = 0;
  double pyramid_ms = 0;    ///< median of this stage
  double edges_ms = 0;      ///< median of this stage
  double alignment_ms = 0;  ///< median of this stage
};

TimeSummary summarize(const std::vector<StageTimes>& times);

/// Returns CSV with one line per frame: stamp, status, why it is lost, why the alignment ended,
/// iterations, points, visible fraction, correlation, depth agreement, cost, conditioning, noise
/// share, read-out time, vignette, stamp of the reference (empty without one), and the upper
/// triangles row by row of two covariances of increments left of a pose ([translation; rotation], m
/// and rad, in the camera's own frame): of T_camera_reference, and the absolute one, of
/// T_camera_world.
std::string format_frame_log(const std::vector<TrackingResult>& frames);

}  // namespace vo
