#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tools/scenario/run_scenario.h"
#include "vo/alignment/align_result.h"
#include "vo/core/image.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

inline constexpr double kMmPerM = 1000;
inline constexpr double kUnknown =
    std::numeric_limits<double>::quiet_NaN();  ///< a value that could not be measured

/// A sequence with known poses, held in memory because a study tracks it many times.
struct Clip {
  std::string name;
  vo::PinholeCamera camera;
  vo::Trajectory truth;
  std::vector<vo::RgbdFrame> frames;
};

/// Loads the first `max_frames` frames, or all if it is 0. Throws vo::Error without ground truth.
Clip load_clip(const vo::SequenceReader& sequence, const std::string& name, std::size_t max_frames,
               const vo::Progress& progress);

/// Loads all frames of a scenario's sequence, which is rendered unless the cache holds it.
Clip load_clip(const Scenario& scenario, const std::filesystem::path& cache,
               const RunProgress& progress);

/// The errors of an estimated trajectory. NaN where too little was tracked.
struct ClipErrors {
  double rpe_mm =
      kUnknown;  ///< RMSE over 1 s, or over half of the estimate if it spans less than 2 s
  double rpe_deg = kUnknown;
  double ate_mm = kUnknown;    ///< RMSE after a rigid (SE(3)) alignment
  double worst_mm = kUnknown;  ///< greatest position error after that alignment
};

ClipErrors errors_of(const vo::Trajectory& truth, const vo::Trajectory& estimate);

/// Accuracy and cost of tracking a clip with one set of options.
struct ClipScore : ClipErrors {
  double points = 0;           ///< points aligned on the finest level, mean over the tracked frames
  double ms_per_frame = 0;     ///< median processor time; differs between runs
  double tracked_percent = 0;  ///< share of all frames with a pose
};

ClipScore score(const Clip& clip, const vo::TrackerOptions& options);

/// Two frames of a clip and their true relative pose.
struct FramePair {
  std::size_t ref = 0;
  std::size_t cur = 0;
  vo::SE3 T_cur_ref;  ///< ground truth
};

/// Returns at most `count` pairs, `distance` frames apart, spread evenly over the clip and without
/// those whose poses the ground truth does not cover.
std::vector<FramePair> pairs_apart(const Clip& clip, std::size_t distance, std::size_t count);

/// Returns the frame's image pyramid with edges, built with the tracker's options.
vo::FramePyramid pyramid_of(const vo::RgbdFrame& frame, const vo::PinholeCamera& camera,
                            const vo::TrackerOptions& options);

struct PoseError {
  double mm = 0;
  double deg = 0;
};

PoseError pose_error(const vo::SE3& T_true, const vo::SE3& T_estimated);

/// Alignments of many pairs under one condition.
struct PairScores {
  std::vector<double> mm;   ///< errors of position
  std::vector<double> deg;  ///< errors of rotation
  std::vector<double> points;
  std::vector<double> iterations;
  int converged = 0;

  void add(const PoseError& error, const vo::AlignResult& alignment);

  double percent() const { return 100.0 * converged / static_cast<double>(mm.size()); }
};

/// Returns the mean displacement, px, of the pixels that have depth and stay in front of the
/// camera. Only every `step`-th pixel in each direction is sampled.
double mean_flow_px(const vo::DepthImage& depth, const vo::PinholeCamera& camera,
                    const vo::SE3& T_cur_ref, int step);

}  // namespace tools
