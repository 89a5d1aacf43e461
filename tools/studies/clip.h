#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/image.h"
#include "vo/core/progress.h"
#include "vo/dataset/sequence.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {

inline constexpr double kMmPerM = 1000;

/// A sequence with known poses, held in memory because a study tracks it many times.
struct Clip {
  std::string name;
  vo::PinholeCamera camera;
  vo::Trajectory truth;
  std::vector<vo::RgbdFrame> frames;
};

/// The first `max_frames` frames, all of them where it is 0. Throws vo::Error without ground truth.
Clip load_clip(const vo::SequenceReader& sequence, const std::string& name, std::size_t max_frames,
               const vo::Progress& progress);

/// How one way of tracking a clip did. NaN where too little was tracked to measure.
struct ClipScore {
  double rpe_mm = 0;  ///< RMSE over one second, or over all of a shorter clip
  double rpe_deg = 0;
  double ate_mm = 0;           ///< RMSE after a rigid alignment
  double points = 0;           ///< aligned on the finest level, mean of the tracked frames
  double ms_per_frame = 0;     ///< median processor time; differs from run to run
  double tracked_percent = 0;  ///< of all frames
};

ClipScore score(const Clip& clip, const vo::TrackerOptions& options);

/// Of two frames of a clip.
struct FramePair {
  std::size_t ref = 0;
  std::size_t cur = 0;
  vo::SE3 T_cur_ref;  ///< the truth
};

/// At most `count` pairs, `distance` frames apart, spread evenly over the clip; none of frames that
/// the truth does not cover.
std::vector<FramePair> pairs_apart(const Clip& clip, std::size_t distance, std::size_t count);

/// As the tracker sees the frame: pyramid and edges.
vo::FramePyramid pyramid_of(const vo::RgbdFrame& frame, const vo::PinholeCamera& camera,
                            const vo::TrackerOptions& options);

struct PoseError {
  double mm = 0;
  double deg = 0;
};

PoseError pose_error(const vo::SE3& T_true, const vo::SE3& T_estimated);

/// Mean displacement of the pixels that have depth and stay in front of the camera, px. Every
/// `step`-th pixel in both directions is looked at.
double mean_flow_px(const vo::DepthImage& depth, const vo::PinholeCamera& camera,
                    const vo::SE3& T_cur_ref, int step);

}  // namespace tools
