#include "tools/pictures/scene_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace tools {
namespace {

using Voxel = std::array<std::int64_t, 3>;

struct Box {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Vector3f high = -low;

  float longest_side() const { return (high - low).maxCoeff(); }
};

Box bounds(const std::vector<ColouredPoint>& points) {
  Box box;
  for (const ColouredPoint& point : points) {
    box.low = box.low.cwiseMin(point.position);
    box.high = box.high.cwiseMax(point.position);
  }
  return box;
}

Voxel voxel_of(const Eigen::Vector3f& position, float side) {
  const Eigen::Array3f cell = (position / side).array().floor();
  return {static_cast<std::int64_t>(cell.x()), static_cast<std::int64_t>(cell.y()),
          static_cast<std::int64_t>(cell.z())};
}

/// Returns the first point of each voxel, in the order of the voxels.
std::vector<ColouredPoint> first_of_voxels(const std::vector<ColouredPoint>& points, float side) {
  std::vector<std::pair<Voxel, std::size_t>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    order.emplace_back(voxel_of(points[i].position, side), i);
  }
  std::sort(order.begin(), order.end());
  const auto end = std::unique(order.begin(), order.end(),
                               [](const auto& a, const auto& b) { return a.first == b.first; });
  std::vector<ColouredPoint> kept;
  for (auto it = order.begin(); it != end; ++it) {
    kept.push_back(points[it->second]);
  }
  return kept;
}

std::vector<ColouredPoint> in_world(const std::vector<SceneView>& views,
                                    const vo::Trajectory& trajectory) {
  std::vector<ColouredPoint> points;
  for (const SceneView& view : views) {
    const std::optional<vo::SE3> T_world_camera = vo::pose_at(trajectory, view.timestamp);
    if (!T_world_camera) {
      continue;
    }
    for (const auto& [p_camera, rgb] : view.points) {
      const Eigen::Vector3d p_world = *T_world_camera * Eigen::Vector3d(p_camera.cast<double>());
      points.push_back({p_world.cast<float>(), rgb});
    }
  }
  return points;
}

void append_int16(std::string& bytes, double value) {
  const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(value)));
  bytes += static_cast<char>(bits & 0xffU);
  bytes += static_cast<char>(bits >> 8U);
}

}  // namespace

SceneView scene_view(double timestamp, const vo::PyramidLevel& level,
                     const cv::Mat_<cv::Vec3b>& picture) {
  constexpr int kColumns = 64;
  SceneView view{timestamp, {}};
  const int step = std::max(1, level.depth.cols / kColumns);
  for (int v = step / 2; v < level.depth.rows; v += step) {
    for (int u = step / 2; u < level.depth.cols; u += step) {
      const float depth = level.depth(v, u);
      if (vo::has_depth(depth)) {
        const cv::Vec2f& ray = level.rays(v, u);
        const cv::Vec3b& bgr = picture(v, u);
        view.points.push_back(
            {depth * Eigen::Vector3f(ray[0], ray[1], 1), {bgr[2], bgr[1], bgr[0]}});
      }
    }
  }
  return view;
}

std::vector<ColouredPoint> merge_views(const std::vector<SceneView>& views,
                                       const vo::Trajectory& trajectory, std::size_t max_points) {
  constexpr float kFirstVoxel = 0.01F;  // m
  constexpr float kGrowth = 1.25F;
  std::vector<ColouredPoint> points = in_world(views, trajectory);
  for (float side = kFirstVoxel; points.size() > max_points; side *= kGrowth) {
    points = first_of_voxels(points, side);
  }
  return points;
}

PointCloud quantised(const std::vector<ColouredPoint>& points) {
  PointCloud cloud;
  cloud.count = points.size();
  if (points.empty()) {
    return cloud;
  }
  constexpr double kUnits = 2.0 * std::numeric_limits<std::int16_t>::max();
  const Box box = bounds(points);
  const Eigen::Vector3d middle = (box.low + box.high).cast<double>() / 2;
  cloud.step = std::max(static_cast<double>(box.longest_side()) / kUnits, 1e-6);
  cloud.origin = {middle.x(), middle.y(), middle.z()};
  for (const ColouredPoint& point : points) {
    const Eigen::Vector3d units = (point.position.cast<double>() - middle) / cloud.step;
    for (const double value : units) {
      append_int16(cloud.positions, value);
    }
    cloud.colours.append({static_cast<char>(point.rgb[0]), static_cast<char>(point.rgb[1]),
                          static_cast<char>(point.rgb[2])});
  }
  return cloud;
}

}  // namespace tools
