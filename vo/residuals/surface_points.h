#pragma once

#include <algorithm>
#include <vector>

#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"

namespace vo {

/// Points on the smooth parts of a depth image, on a regular grid, in the camera's frame.
struct SurfacePoints {
  std::vector<Eigen::Vector3f> position;  ///< m
  std::vector<Eigen::Vector3f> normal;    ///< of unit length, pointing away from the camera

  std::size_t size() const { return position.size(); }
  std::size_t memory_bytes() const { return size() * 2 * sizeof(Eigen::Vector3f); }
};

/// Distance of the surface points' pixels from each other in a row and in a column, px.
inline constexpr int kSurfaceSpacing = 8;

/// Finds the surface points of a level. A plane 1 / Z = a X / Z + b Y / Z + c, which is linear in
/// what is measured, is fitted around every eighth pixel; pixels with holes around them, or whose
/// surroundings are not flat, are left out.
SurfacePoints surface_points(const PyramidLevel& level);

/// Returns the level that surfaces are taken from: coarse enough to average out noise, and 160 px
/// wide for 640 px wide images.
inline std::size_t surface_level(const FramePyramid& frame) {
  return std::min<std::size_t>(2, frame.levels.size() - 1);
}

}  // namespace vo
