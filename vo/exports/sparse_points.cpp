#include "vo/exports/sparse_points.h"

#include <cmath>

#include "vo/geometry/projection.h"

namespace vo {
namespace {

constexpr int kCell = 16;            // px
constexpr float kSameDepth = 0.02F;  // relative

cv::Vec3b colour_at(const cv::Mat& image, const cv::Point& pixel) {
  if (image.channels() == 1) {
    const uchar grey = image.at<uchar>(pixel);
    return {grey, grey, grey};
  }
  return image.at<cv::Vec3b>(pixel);
}

bool is_same_depth(float a, float b) {
  return has_depth(a) && has_depth(b) && std::abs(a - b) <= kSameDepth * b;
}

/// Returns whether depth is measured at and around a pixel and has no step there.
bool is_on_surface(const DepthImage& depth, const cv::Point& pixel) {
  constexpr int kReach = 2;  // px
  const cv::Rect inside(kReach, kReach, depth.cols - 2 * kReach, depth.rows - 2 * kReach);
  return inside.contains(pixel) && is_same_depth(depth(pixel.y, pixel.x - kReach), depth(pixel)) &&
         is_same_depth(depth(pixel.y, pixel.x + kReach), depth(pixel)) &&
         is_same_depth(depth(pixel.y - kReach, pixel.x), depth(pixel)) &&
         is_same_depth(depth(pixel.y + kReach, pixel.x), depth(pixel));
}

}  // namespace

void SparsePoints::add(const RgbdFrame& frame, const SE3& T_world_camera) {
  views_.emplace_back();
  if (frame.depth.empty()) {
    return;
  }
  cv::Mat_<uchar> taken((camera_.height - 1) / kCell + 1, (camera_.width - 1) / kCell + 1,
                        uchar{0});
  see_again(frame, T_world_camera, taken);
  add_new(frame, T_world_camera, taken);
}

void SparsePoints::see_again(const RgbdFrame& frame, const SE3& T_world_camera,
                             cv::Mat_<uchar>& taken) {
  const SE3 T_camera_world = T_world_camera.inverse();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d p_camera = T_camera_world * points_[i].p_world;
    if (p_camera.z() < kMinVisibleDepth) {
      continue;
    }
    const Eigen::Vector2d pixel = camera_.project(p_camera);
    if (!camera_.contains(pixel)) {
      continue;
    }
    const cv::Point nearest(static_cast<int>(std::lround(pixel.x())),
                            static_cast<int>(std::lround(pixel.y())));
    uchar& cell = taken(nearest.y / kCell, nearest.x / kCell);
    if (cell == 0 && is_same_depth(frame.depth(nearest), static_cast<float>(p_camera.z()))) {
      cell = 1;
      views_.back().push_back({i, pixel});
      ++points_[i].views;
    }
  }
}

void SparsePoints::add_new(const RgbdFrame& frame, const SE3& T_world_camera,
                           const cv::Mat_<uchar>& taken) {
  for (int row = 0; row < taken.rows; ++row) {
    for (int column = 0; column < taken.cols; ++column) {
      const cv::Point pixel(column * kCell + kCell / 2, row * kCell + kCell / 2);
      if (taken(row, column) != 0 || !is_on_surface(frame.depth, pixel)) {
        continue;
      }
      const Eigen::Vector2d centre(pixel.x, pixel.y);
      const Eigen::Vector3d p_camera = camera_.unproject(centre, frame.depth(pixel));
      if (p_camera.allFinite()) {
        views_.back().push_back({points_.size(), centre});
        points_.push_back({T_world_camera * p_camera, colour_at(frame.image, pixel), 1});
      }
    }
  }
}

}  // namespace vo
