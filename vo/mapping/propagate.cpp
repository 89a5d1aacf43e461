#include "vo/mapping/propagate.h"

#include <algorithm>
#include <cmath>

#include "vo/geometry/projection.h"
#include "vo/mapping/moved_edges.h"
#include "vo/mapping/nearest_edge.h"

namespace vo {
namespace {

constexpr double kPropagationSigma = 0.002;  // relative, added when the host changes

/// Puts a moved hypothesis at an edge pixel of the next host, or decides which one stays there.
void settle(const Hypotheses& from, const MovedEdge& moved, std::size_t j, Hypotheses& next,
            PropagationCounts& counts) {
  const std::size_t i = moved.hypothesis;
  constexpr float kMinShare = 0.8F;  // least share of a variance: a repeated measurement is no news
  const auto put = [&] {
    next.set(j, moved.inverse_depth, moved.variance);
    next.state[j] = from.state[i];
    next.inliers[j] = from.inliers[i];
    next.outliers[j] = from.outliers[i];
  };
  ++counts.moved;
  if (next.state[j] == DepthState::none) {
    put();
    return;
  }
  const float sum = moved.variance + next.variance[j];
  const float difference = moved.inverse_depth - next.inverse_depth[j];
  if (difference * difference > 4 * sum) {
    ++counts.occluded;
    if (difference > 0) {
      put();
    }
    return;
  }
  ++counts.merged;
  const float least = kMinShare * std::min(moved.variance, next.variance[j]);
  next.inverse_depth[j] += next.variance[j] / sum * difference;
  next.smoothed[j] = next.inverse_depth[j];
  next.variance[j] = std::max(moved.variance * next.variance[j] / sum, least);
  next.smoothed_variance[j] = next.variance[j];
  next.state[j] = std::max(next.state[j], from.state[i]);
  next.inliers[j] = std::max(next.inliers[j], from.inliers[i]);
  next.outliers[j] = std::min(next.outliers[j], from.outliers[i]);
}

}  // namespace

MovedDepth moved_depth(const StereoPair& pair, const Eigen::Vector2f& ray, float inverse_depth,
                       float variance, float relative_noise) {
  const Eigen::Matrix3f R_cur_host = pair.lines.of_middle.leftCols<3>();
  const Eigen::Vector3f t_cur_host = pair.lines.of_middle.col(3);
  const Eigen::Vector3f P = R_cur_host * ray.homogeneous() + inverse_depth * t_cur_host;
  constexpr float kMinDepthRatio = 0.01F;
  if (!(P.z() > kMinDepthRatio)) {
    return {};
  }
  const float d = inverse_depth / P.z();
  // d d'/d d = (R ray)_z / P_z^2: equal to (d'/d)^2 where the camera does not turn.
  const float growth = (P.z() - inverse_depth * t_cur_host.z()) / (P.z() * P.z());
  const float noise = relative_noise * d;
  return {d, growth * growth * variance + noise * noise, P.hnormalized()};
}

PropagationCounts propagate(const StereoPair& pair, const Hypotheses& hypotheses,
                            Hypotheses& next) {
  PropagationCounts counts;
  const auto noise = static_cast<float>(kPropagationSigma);
  for (const MovedEdge& moved : move_edges(pair, hypotheses, noise, available_instruction_set())) {
    if (!moved.is_visible) {
      ++counts.out_of_view;
      continue;
    }
    if (moved.is_changed) {
      ++counts.occluded;
      continue;
    }
    const int j = nearest_edge(next, moved);
    if (j < 0) {
      ++counts.without_edge;
      continue;
    }
    settle(hypotheses, moved, static_cast<std::size_t>(j), next, counts);
  }
  return counts;
}

SeenEdges seen_edges(const StereoPair& pair, const Hypotheses& hypotheses, std::size_t stride) {
  const Projection<float> projection(pair.current.camera);
  const SeenBounds bounds(pair.current.camera.width, pair.current.camera.height);
  SeenEdges edges;
  for (std::size_t i = 0; i < hypotheses.size(); i += stride) {
    const cv::Vec2f& ray = hypotheses.ray[i];
    const MovedDepth moved = moved_depth(pair, {ray[0], ray[1]}, hypotheses.inverse_depth[i], 0, 0);
    const ImagedDirection<float> imaged = image_direction(projection, moved.ray.x(), moved.ray.y());
    edges.asked += 1;
    if (moved.inverse_depth > 0 && bounds.holds(imaged.u, imaged.v)) {
      edges.seen += 1;
      edges.flow_px += std::hypot(imaged.u - static_cast<float>(hypotheses.pixel[i].x),
                                  imaged.v - static_cast<float>(hypotheses.pixel[i].y));
    }
  }
  return edges;
}

}  // namespace vo
