#include "vo/image/edge_points.h"

#include <cassert>

#include "vo/core/error.h"

namespace vo {
namespace {

EdgeMask edge_mask(const PyramidLevel& reference, const PyramidLevel& current, EdgeSource source) {
  if (source == EdgeSource::both) {
    EdgeMask either;
    cv::bitwise_or(reference.edges, current.edges, either);
    return either;
  }
  return source == EdgeSource::reference ? reference.edges : current.edges;
}

bool is_usable(float depth, const EdgePointOptions& options) {
  return depth >= options.min_depth && depth <= options.max_depth;
}

EdgePointLevel level_points(const PyramidLevel& reference, const EdgeMask& mask,
                            const EdgePointOptions& options) {
  EdgePointLevel points;
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const float depth = reference.depth(v, u);
      if (mask(v, u) == 0 || !is_usable(depth, options)) {
        continue;
      }
      const Eigen::Vector3d p_ref = reference.camera.unproject({u, v}, depth);
      points.x_ref.push_back(static_cast<float>(p_ref.x()));
      points.y_ref.push_back(static_cast<float>(p_ref.y()));
      points.z_ref.push_back(depth);
      points.intensity.push_back(reference.intensity(v, u));
      points.pixel.emplace_back(u, v);
    }
  }
  return points;
}

}  // namespace

void EdgePointOptions::validate() const {
  require(min_depth > 0 && max_depth > min_depth,
          "points: expected 0 < min_depth < max_depth, got ", min_depth, " and ", max_depth);
}

std::size_t edge_pixels_with_depth(const PyramidLevel& level, const EdgePointOptions& options) {
  std::size_t count = 0;
  for (int v = 0; v < level.edges.rows; ++v) {
    for (int u = 0; u < level.edges.cols; ++u) {
      count += level.edges(v, u) != 0 && is_usable(level.depth(v, u), options) ? 1 : 0;
    }
  }
  return count;
}

EdgePoints edge_points(const FramePyramid& reference, const FramePyramid& current,
                       const EdgePointOptions& options) {
  assert(reference.levels.size() == current.levels.size());
  EdgePoints points;
  for (std::size_t l = 0; l < reference.levels.size(); ++l) {
    const EdgeMask mask = edge_mask(reference.levels[l], current.levels[l], options.source);
    points.levels.push_back(level_points(reference.levels[l], mask, options));
  }
  return points;
}

}  // namespace vo
