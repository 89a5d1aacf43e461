#pragma once

#include <functional>
#include <string>
#include <vector>

#include "vo/core/progress.h"
#include "vo/io/sequence.h"
#include "vo/odometry.h"

namespace tools {

/// What tracking a whole sequence gave, frame by frame.
struct SequenceResult {
  std::vector<vo::TrackingResult> frames;
  std::vector<vo::StageTimes> times;  ///< diagnostic, differs from run to run
  vo::Trajectory trajectory;          ///< without the lost frames

  double tracked_fraction() const;  ///< of all frames, the first one counted as tracked
  std::size_t keyframes() const;
};

/// Told after each frame, before the next one is read: for pictures.
using FrameObserver =
    std::function<void(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                       const vo::Tracker& tracker, const vo::TrackingResult& result)>;

SequenceResult track_sequence(const vo::SequenceReader& sequence, const vo::TrackerOptions& options,
                              const vo::SE3& T_world_first, const FrameObserver& observe,
                              const vo::Progress& progress);

/// The nearest-rank percentile of a fraction 0..1; 0 without values.
double percentile(std::vector<double> values, double fraction);

/// Median and 90th percentile over the frames, ms.
struct TimeSummary {
  double median_ms = 0;
  double p90_ms = 0;
  double pyramid_ms = 0;    ///< median
  double edges_ms = 0;      ///< median
  double alignment_ms = 0;  ///< median
};

TimeSummary summarize(const std::vector<vo::StageTimes>& times);

/// CSV with one line per frame: stamp, status, why it is lost, why the alignment ended, iterations,
/// points, visible fraction, correlation, depth agreement, cost, conditioning, read-out time,
/// vignette and the upper triangle of the covariance row by row ([translation; rotation], m and
/// rad).
std::string format_frame_log(const std::vector<vo::TrackingResult>& frames);

}  // namespace tools
