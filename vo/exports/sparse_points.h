#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace vo {

/// A point on a surface, from the depth of the frame that saw it first.
struct SparsePoint {
  Eigen::Vector3d p_world;  ///< m
  cv::Vec3b colour;         ///< BGR
  int views = 0;            ///< frames that see it
};

/// Where a frame sees a point.
struct PointView {
  std::size_t point = 0;  ///< index among the points
  Eigen::Vector2d pixel;
};

/// Collects points on what frames with depth and pose see, and which frames see each: a few for
/// every part of each image, so that their number grows with what is seen and not with the frames.
/// A frame sees a point where its depth agrees within 2 %. Of the points in a cell of 16x16 px the
/// oldest counts; a cell without gets a new one, unless depth has a step of 2 % there.
class SparsePoints {
 public:
  explicit SparsePoints(const PinholeCamera& camera) : camera_(camera) {}

  /// Adds the next frame, which need not have depth.
  void add(const RgbdFrame& frame, const SE3& T_world_camera);

  const std::vector<SparsePoint>& points() const { return points_; }
  const std::vector<std::vector<PointView>>& views() const { return views_; }  ///< by frame

 private:
  void see_again(const RgbdFrame& frame, const SE3& T_world_camera, cv::Mat_<uchar>& taken);
  void add_new(const RgbdFrame& frame, const SE3& T_world_camera, const cv::Mat_<uchar>& taken);

  PinholeCamera camera_;
  std::vector<SparsePoint> points_;
  std::vector<std::vector<PointView>> views_;
};

}  // namespace vo
