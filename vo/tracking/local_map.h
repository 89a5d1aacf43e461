#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/frame_velocity.h"
#include "vo/residuals/surface_points.h"
#include "vo/tracking/map_options.h"

namespace vo {

/// A frame that others are aligned to.
struct Keyframe {
  FramePyramid pyramid;
  std::shared_ptr<const EdgePoints> points;  ///< of its own edges
  SE3 T_world_keyframe;
  std::optional<FrameVelocity>
      velocity;  ///< of the camera in its own frame, m/s and rad/s; if known
  std::shared_ptr<const SurfacePoints> surface;  ///< where depth is aligned, too
  std::vector<float> measured_depth;  ///< m, of the finest points; where the window is adjusted
};

/// How the points of one frame move in the image of another.
struct ImageMotion {
  double overlap = 0;  ///< share of the points that is seen
  double flow_px = 0;  ///< mean displacement of those, px of the finest level
};

/// Measured on the points of the coarsest level.
ImageMotion image_motion(const EdgePoints& points, const FramePyramid& frame, const SE3& T_cur_ref);

/// The keyframes around the camera.
class LocalMap {
 public:
  explicit LocalMap(const MapOptions& options) : options_(options) {}

  bool empty() const { return keyframes_.empty(); }
  const std::shared_ptr<const Keyframe>& last() const { return keyframes_.back(); }
  const std::deque<std::shared_ptr<const Keyframe>>& keyframes() const { return keyframes_; }
  std::size_t memory_bytes() const;  ///< of the images and points of all keyframes
  void add(Keyframe keyframe);
  void take_out(const Vignette& vignette);  ///< of the keyframes that it changes noticeably
  void set_last_velocity(const FrameVelocity& velocity);           ///< once the next frame has told
  void set_last_points(std::shared_ptr<const EdgePoints> points);  ///< as far as they are known now

  /// Where it is by now, and its finest points.
  void adjust(std::size_t keyframe, const SE3& T_world_keyframe, EdgePointLevel finest);

  /// The keyframe that the camera sees most alike, then the next, at most `references`; the last
  /// keyframe where none has enough in common.
  std::vector<std::shared_ptr<const Keyframe>> references_for(const SE3& T_world_camera) const;

  /// The last keyframe, then those that it sees most alike; indices, at most `count`.
  std::vector<std::size_t> around_last(std::size_t count) const;

 private:
  std::vector<std::size_t> seen_from(const SE3& T_world_camera, std::size_t count) const;

  MapOptions options_;
  std::deque<std::shared_ptr<const Keyframe>> keyframes_;  ///< oldest first
};

}  // namespace vo
