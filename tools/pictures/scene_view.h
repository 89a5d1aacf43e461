#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "vo/geometry/trajectory.h"
#include "vo/image/pyramid.h"

namespace tools {

struct ColouredPoint {
  Eigen::Vector3f position;           ///< m
  std::array<std::uint8_t, 3> rgb{};  ///< sRGB
};

/// Some of what a frame's depth image shows, in the camera's frame.
struct SceneView {
  double timestamp = 0;  ///< s
  std::vector<ColouredPoint> points;
};

/// Pixels with depth on a regular grid. `picture` has the level's size.
SceneView scene_view(double timestamp, const vo::PyramidLevel& level,
                     const cv::Mat_<cv::Vec3b>& picture);

/// The views in world coordinates, seen from the trajectory's poses: one point of each voxel, the
/// voxels so large that there are at most `max_points`. Views outside its time span are left out.
std::vector<ColouredPoint> merge_views(const std::vector<SceneView>& views,
                                       const vo::Trajectory& trajectory, std::size_t max_points);

/// Points in 16 bits a coordinate.
struct PointCloud {
  std::size_t count = 0;
  std::array<double, 3> origin{};  ///< m, world
  double step = 0;                 ///< m, of one unit
  std::string positions;  ///< int16 x, y, z of each point, little-endian: origin + step * n
  std::string colours;    ///< uint8 r, g, b of each point
};

PointCloud quantised(const std::vector<ColouredPoint>& points);

}  // namespace tools
