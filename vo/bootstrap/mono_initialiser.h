#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "vo/bootstrap/corner_tracks.h"
#include "vo/bootstrap/start_adjustment.h"
#include "vo/bootstrap/two_view.h"
#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"

namespace vo {

/// The verdict on the motion since the held frame.
enum class InitialiserVerdict {
  waiting,        ///< too little parallax so far
  pure_rotation,  ///< the image moves, and a rotation of the camera explains it
  inconsistent,   ///< no rigid motion explains the image motion
  ambiguous,      ///< all is on a plane, and two motions past it explain the frames alike
  solved,
};

constexpr auto enum_names(InitialiserVerdict) {
  return std::array{std::pair{InitialiserVerdict::waiting, "waiting"},
                    std::pair{InitialiserVerdict::pure_rotation, "pure_rotation"},
                    std::pair{InitialiserVerdict::inconsistent, "inconsistent"},
                    std::pair{InitialiserVerdict::ambiguous, "ambiguous"},
                    std::pair{InitialiserVerdict::solved, "solved"}};
}

struct InitialiserReport {
  InitialiserVerdict verdict = InitialiserVerdict::waiting;
  double flow_px = 0;      ///< median displacement of the corners since the held frame
  double parallax_px = 0;  ///< median displacement that no rotation explains
};

/// The distance that the camera must have moved, as the median parallax of the corners.
struct StartParallax {
  double least_px = 4;    ///< enough to solve with when corners or time run out
  double wanted_px = 25;  ///< waited for as long as corners and time allow
};

/// A frame of the start, its pose relative to the first and its velocity.
struct StartFrame {
  FramePyramid pyramid;
  SE3 T_frame_first;
  Vector6d velocity = Vector6d::Zero();  ///< in the camera's own frame, m/s and rad/s
};

/// Initialises a monocular map: finds structure and motion of an unknown scene together. The first
/// frame is held and its corners are followed until the camera has moved far enough; then motion
/// and all inverse depths are fitted together, at first to the last frame alone, then to all. Where
/// a homography explains the last frame as well as free depths do, each of the plane's motions is
/// fitted to all frames, and the better one counts once it is clearly better. The scale is chosen
/// so that the median depth is what was asked for.
class MonoInitialiser {
 public:
  /// Without a known read-out, that of a rolling shutter is estimated, too.
  MonoInitialiser(const FramePyramid& first, const StartParallax& parallax, double median_depth,
                  std::optional<Readout> known_readout = {});

  InitialiserReport add(const FramePyramid& frame);

  /// Ends the sequence: solves with the least parallax if the last frame has that much.
  InitialiserReport finish();

  /// Returns whether the held frame is out of view, or too many frames were seen, to start anew.
  bool is_exhausted() const;

  /// Once solved, these return all frames, the first included, the read-out, and the depth
  /// of the first frame at every edge pixel, interpolated between corners.
  const std::vector<StartFrame>& frames() const { return frames_; }
  Readout readout() const { return readout_; }
  DepthImage depth_at_edges() const;

 private:
  std::vector<RayPair> ray_pairs() const;
  InitialiserReport judge(double sufficient_px);
  InitialiserVerdict solve(const RotationFit& turn, double parallax_px);
  std::vector<TwoViewFit> explanations(const RotationFit& turn) const;
  double robust_scale() const;
  std::vector<double> timestamps() const;
  bool is_running_out() const;
  StartViews views(const std::vector<double>& inverse_depth) const;
  void take(const StartViews& adjusted, const std::vector<Vector6d>& velocities);

  StartParallax parallax_;
  std::size_t frames_to_least_ = 0;  ///< frames until the least parallax, 0 before
  double median_depth_;
  Readout readout_;
  bool readout_is_known_;
  CornerTracks tracks_;
  std::vector<StartFrame> frames_;
  std::vector<std::vector<RayPair>> pairs_;        ///< ray pairs of each frame after the first
  std::vector<std::vector<std::size_t>> corners_;  ///< indices of the corners of pairs_
  std::vector<Eigen::Vector2d> known_pixels_;      ///< px, in the first frame
  std::vector<double> known_inverse_depth_;        ///< 1/m, at known_pixels_
};

}  // namespace vo
