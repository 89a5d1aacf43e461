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

/// What the motion since the held frame allows.
enum class InitialiserVerdict {
  waiting,        ///< too little parallax so far
  pure_rotation,  ///< the image moves, and turning the camera explains it
  inconsistent,   ///< no rigid motion explains it
  solved,
};

constexpr auto enum_names(InitialiserVerdict) {
  return std::array{std::pair{InitialiserVerdict::waiting, "waiting"},
                    std::pair{InitialiserVerdict::pure_rotation, "pure_rotation"},
                    std::pair{InitialiserVerdict::inconsistent, "inconsistent"},
                    std::pair{InitialiserVerdict::solved, "solved"}};
}

struct InitialiserReport {
  InitialiserVerdict verdict = InitialiserVerdict::waiting;
  double flow_px = 0;      ///< median displacement since the held frame
  double parallax_px = 0;  ///< median of what no rotation explains
};

/// How far the camera must have moved, as the median parallax of the corners.
struct StartParallax {
  double least_px = 4;    ///< it is solved with, when corners run out
  double wanted_px = 12;  ///< it is waited for, so long as that takes in proportion
};

/// A frame of the start and where it was taken from.
struct StartFrame {
  FramePyramid pyramid;
  SE3 T_frame_first;
};

/// Finds structure and motion of an unknown scene at once: the first frame is held, corners are
/// followed until the camera has moved far enough, then the motion and all inverse depths are
/// fitted together, at first to the last frame alone, then to all. Scale is chosen so that the
/// median depth is what was asked for.
class MonoInitialiser {
 public:
  MonoInitialiser(const FramePyramid& first, const StartParallax& parallax, double median_depth);

  InitialiserReport add(const FramePyramid& frame);

  /// No more frames come: solves with the least parallax where the last frame has that.
  InitialiserReport finish();

  /// Whether the held frame is out of view, or too many frames were seen: start from another.
  bool is_exhausted() const;

  /// Once it is solved: all frames, the first included, and the depth of the first at every edge
  /// pixel, interpolated between corners.
  const std::vector<StartFrame>& frames() const { return frames_; }
  DepthImage depth_at_edges() const;

 private:
  std::vector<RayPair> ray_pairs() const;
  InitialiserReport judge(double sufficient_px);
  InitialiserVerdict solve(const RotationFit& turn, double parallax_px);
  bool is_running_out() const;
  StartViews views(const std::vector<double>& inverse_depth) const;
  void take(const StartViews& adjusted);

  StartParallax parallax_;
  std::size_t frames_to_least_ = 0;  ///< until the least parallax was there, 0 before
  double median_depth_;
  CornerTracks tracks_;
  std::vector<StartFrame> frames_;
  std::vector<std::vector<RayPair>> pairs_;        ///< of each frame after the first
  std::vector<std::vector<std::size_t>> corners_;  ///< which corners those are
  std::vector<Eigen::Vector2d> known_pixels_;      ///< px, of the first
  std::vector<double> known_inverse_depth_;        ///< 1/m
};

}  // namespace vo
