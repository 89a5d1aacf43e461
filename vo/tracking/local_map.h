#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "vo/alignment/joint_problem.h"
#include "vo/core/inplace_vector.h"
#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/frame_velocity.h"
#include "vo/residuals/surface_points.h"
#include "vo/segmentation/tile_mask.h"
#include "vo/tracking/map_options.h"
#include "vo/tracking/window_options.h"

namespace vo {

/// A frame that others are aligned to, with its points and its pose.
struct Keyframe {
  FramePyramid pyramid;
  std::shared_ptr<const EdgePoints> points;  ///< edge points of this frame
  SE3 T_world_keyframe;
  std::optional<FrameVelocity> velocity;  ///< in the camera's own frame, m/s and rad/s; if known
  std::shared_ptr<const SurfacePoints> surface;  ///< surface points for depth alignment, or null
  std::vector<float> measured_depth;  ///< m, of the finest points if the window adjusts depth
  Readout readout;                    ///< rolling shutter's read-out by which the pose was found
  TileMask moved;  ///< tiles of its view with what moved by itself, when it was taken or since
  Matrix6d absolute_covariance =
      Matrix6d::Zero();  ///< of T_world_keyframe, as in TrackingResult; not adjusted by the window

  bool is_uncertain = false;  ///< whether its pose must not be relied on

  /// Returns whether much of the view has moved: what it hid then is seen now. Of the keyframes of
  /// fr1/xyz, where nothing moves, less than that is taken to have moved.
  bool is_disturbed() const {
    constexpr double kMuch = 0.12;
    return share_of_view(moved) > kMuch;
  }
};

/// The keyframes around the camera.
class LocalMap {
 public:
  explicit LocalMap(const MapOptions& options) : options_(options) {}

  using References = InplaceVector<std::shared_ptr<const Keyframe>, kMaxReferences>;

  bool empty() const { return keyframes_.empty(); }
  const std::shared_ptr<const Keyframe>& last() const { return keyframes_.back(); }
  const std::deque<std::shared_ptr<const Keyframe>>& keyframes() const { return keyframes_; }
  std::size_t memory_bytes() const;  ///< bytes of all keyframes
  void add(Keyframe keyframe);
  void clear() { keyframes_.clear(); }
  void take_out(const Vignette& vignette);  ///< removes it where it shows

  /// Forgets keyframes whose points move by more than half a pixel, between the first and the last
  /// line, when the read-out becomes this one: their poses were found in images bent by as much.
  /// The last keyframe stays.
  void forget_bent(const Readout& readout);
  void set_last_velocity(const FrameVelocity& velocity);  ///< for when the next frame tells
  void set_last_points(std::shared_ptr<const EdgePoints> points);  ///< with newer depths

  /// Leaves out of a keyframe what has moved by itself, in these tiles of its view.
  void leave_out(const Keyframe& keyframe, const TileMask& tiles);

  /// Replaces a keyframe's pose and its points of the finest level.
  void adjust(std::size_t keyframe, const SE3& T_world_keyframe, EdgePointLevel finest);

  /// Returns at most `references` keyframes that overlap enough, least displacement first, or the
  /// last keyframe where none does or `references` is 1.
  References references_for(const SE3& T_world_camera) const;

  /// Returns the indices of the last keyframe, then of those it sees most alike, at most `count`.
  std::vector<std::size_t> around_last(std::size_t count) const;

 private:
  struct RankedKeyframe {
    double flow_px;     ///< displacement of its points
    std::size_t index;  ///< in `keyframes_`
  };
  using Ranking = InplaceVector<RankedKeyframe, kMaxWindow + 1>;  ///< room for one more to enter

  Ranking seen_from(const SE3& T_world_camera, std::size_t count) const;

  MapOptions options_;
  std::deque<std::shared_ptr<const Keyframe>> keyframes_;  ///< oldest first
};

}  // namespace vo
