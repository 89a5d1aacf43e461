#pragma once

#include <optional>

#include <Eigen/Core>

#include "vo/image/pyramid.h"

namespace vo {

/// The normal of a surface as a depth image has it at a pixel.
struct SurfaceNormal {
  /// Scaled to n . (x, y, 1) = 1, where (x, y, 1) is the pixel's ray, so that a point of the
  /// tangent plane on another ray has the inverse depth n . (x', y', 1) times the pixel's.
  Eigen::Vector3f n;

  /// Half the difference between the slopes of the inverse depth to either side, in x and y, over
  /// the inverse depth: the change of n's x and y if one side alone were the surface.
  Eigen::Vector2f deviation;
};

/// Returns the normal from the slopes of the inverse depth, which are constant over the image of a
/// plane, or nothing where the level has no depth at the pixel or at one of the four around it.
std::optional<SurfaceNormal> surface_normal(const PyramidLevel& level, const cv::Point& pixel);

}  // namespace vo
