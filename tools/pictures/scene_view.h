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

/// A sparse sample of a frame's depth image as points in the camera's frame.
struct SceneView {
  double timestamp = 0;  ///< s
  std::vector<ColouredPoint> points;
};

/// Returns the pixels with depth on a regular grid. `picture` has the level's size.
SceneView scene_view(double timestamp, const vo::PyramidLevel& level,
                     const cv::Mat_<cv::Vec3b>& picture);

/// Returns the views in world coordinates, seen from the trajectory's poses, thinned to one point
/// per voxel, the voxels large enough for at most `max_points`. Views outside its time span are
/// left out.
std::vector<ColouredPoint> merge_views(const std::vector<SceneView>& views,
                                       const vo::Trajectory& trajectory, std::size_t max_points);

/// Coloured points with 16 bits per coordinate.
struct PointCloud {
  std::size_t count = 0;
  std::array<double, 3> origin{};  ///< m, world
  double step = 0;                 ///< m per unit
  std::string positions;           ///< int16 x, y, z per point, little-endian: origin + step * n
  std::string colours;             ///< uint8 r, g, b per point
};

PointCloud quantised(const std::vector<ColouredPoint>& points);

}  // namespace tools
