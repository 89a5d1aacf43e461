#include "vo/residuals/surface_points.h"

#include <optional>

#include "vo/core/normal_equations.h"

namespace vo {
namespace {

constexpr int kRadius = 3;  // px, half-width of the neighbourhood that a plane is fitted to

Eigen::Vector3d ray_of(const PyramidLevel& level, int u, int v) {
  return {level.rays(v, u)[0], level.rays(v, u)[1], 1};
}

/// Returns (a, b, c) of the plane a X + b Y + c Z = 1 fitted to the neighbourhood, or nothing if it
/// has holes or is not flat.
std::optional<Eigen::Vector3d> fitted_plane(const PyramidLevel& level, cv::Point centre) {
  constexpr double kMaxResidual = 0.02;  // share of the inverse depth
  NormalEquations<3> equations;
  double sum_of_squares = 0;
  int count = 0;
  for (int v = centre.y - kRadius; v <= centre.y + kRadius; ++v) {
    for (int u = centre.x - kRadius; u <= centre.x + kRadius; ++u) {
      if (!has_depth(level.depth(v, u))) {
        return {};
      }
      const double inverse_depth = 1 / static_cast<double>(level.depth(v, u));
      equations.add_residual(ray_of(level, u, v), -inverse_depth, 1);
      sum_of_squares += inverse_depth * inverse_depth;
      ++count;
    }
  }
  const Eigen::Vector3d plane = equations.step();
  const double residual = (sum_of_squares + plane.dot(equations.b)) / count;
  const double limit = kMaxResidual / static_cast<double>(level.depth(centre));
  if (!(residual < limit * limit)) {
    return {};
  }
  return plane;
}

}  // namespace

SurfacePoints surface_points(const PyramidLevel& level) {
  SurfacePoints points;
  for (int v = kRadius; v < level.depth.rows - kRadius; v += kSurfaceSpacing) {
    for (int u = kRadius; u < level.depth.cols - kRadius; u += kSurfaceSpacing) {
      const Eigen::Vector3d ray = ray_of(level, u, v);
      const std::optional<Eigen::Vector3d> plane = fitted_plane(level, {u, v});
      if (plane && plane->dot(ray) > 0) {
        points.position.emplace_back((ray / plane->dot(ray)).cast<float>());
        points.normal.emplace_back(plane->normalized().cast<float>());
      }
    }
  }
  return points;
}

}  // namespace vo
