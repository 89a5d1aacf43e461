#include "vo/mapping/propagate.h"

#include <algorithm>
#include <cmath>

namespace vo {
namespace {

constexpr float kSnapDistance = 1;   // px, across the edge
constexpr float kMaxTurn = 0.7071F;  // cosine, of the gradient between the images

/// Interpolated ray of a place between pixels.
Eigen::Vector2f ray_at(const RayImage& rays, const cv::Vec2f& at) {
  const int u = std::clamp(static_cast<int>(at[0]), 0, rays.cols - 2);
  const int v = std::clamp(static_cast<int>(at[1]), 0, rays.rows - 2);
  const float du = at[0] - static_cast<float>(u);
  const float dv = at[1] - static_cast<float>(v);
  const cv::Vec2f above = rays(v, u) * (1 - du) + rays(v, u + 1) * du;
  const cv::Vec2f below = rays(v + 1, u) * (1 - du) + rays(v + 1, u + 1) * du;
  const cv::Vec2f ray = above * (1 - dv) + below * dv;
  return {ray[0], ray[1]};
}

/// Where an edge of the anchor appears in the current image.
struct MovedEdge {
  MovedDepth depth;
  Eigen::Vector2f position{0, 0};   ///< px
  Eigen::Vector2f direction{0, 0};  ///< unit, of the gradient
};

MovedEdge move_edge(const StereoPair& pair, const Hypotheses& hypotheses, std::size_t i,
                    const DepthMapOptions& options) {
  const cv::Vec2f edge = hypotheses.edge_position(i);
  const cv::Vec2f beside = edge + hypotheses.across[i];
  const auto noise = static_cast<float>(options.propagation_sigma);
  const float d = hypotheses.inverse_depth[i];
  MovedEdge moved;
  moved.depth = moved_depth(pair, ray_at(pair.anchor.rays, edge), d, hypotheses.variance[i], noise);
  const MovedDepth moved_beside = moved_depth(pair, ray_at(pair.anchor.rays, beside), d, 0, 0);
  if (moved.depth.inverse_depth > 0 && moved_beside.inverse_depth > 0) {
    const PinholeCamera& camera = pair.current.camera;
    moved.position = image_ray(camera, moved.depth.ray).pixel;
    moved.direction = (image_ray(camera, moved_beside.ray).pixel - moved.position).normalized();
  }
  return moved;
}

/// The edge pixel nearest across its own edge; -1 without one of the same direction.
int nearest_edge(const Hypotheses& next, const MovedEdge& moved) {
  constexpr int kRadius = 1;
  const cv::Point centre(static_cast<int>(std::lround(moved.position.x())),
                         static_cast<int>(std::lround(moved.position.y())));
  int best = -1;
  float best_distance2 = 1e9F;
  for (int dv = -kRadius; dv <= kRadius; ++dv) {
    for (int du = -kRadius; du <= kRadius; ++du) {
      const int candidate = next.index(centre + cv::Point(du, dv));
      if (candidate < 0) {
        continue;
      }
      const auto j = static_cast<std::size_t>(candidate);
      const cv::Vec2f& across = next.across[j];
      const cv::Vec2f edge = next.edge_position(j);
      const Eigen::Vector2f away = moved.position - Eigen::Vector2f(edge[0], edge[1]);
      const float distance = std::abs(away.x() * across[0] + away.y() * across[1]);
      const float turn = moved.direction.x() * across[0] + moved.direction.y() * across[1];
      if (distance <= kSnapDistance && turn >= kMaxTurn && away.squaredNorm() < best_distance2) {
        best_distance2 = away.squaredNorm();
        best = candidate;
      }
    }
  }
  return best;
}

/// Whether the current image shows another intensity than the anchor did (the bound is that of
/// LSD-SLAM: 40 grey levels, more on strong gradients).
bool looks_different(const StereoPair& pair, const Hypotheses& hypotheses, std::size_t i,
                     const MovedEdge& moved) {
  constexpr float kMaxDifference = 40.0F / 255;
  const cv::Vec2f edge = hypotheses.edge_position(i);
  const float before = sample_bilinear(pair.anchor.intensity, {edge[0], edge[1]});
  const float now = sample_bilinear(pair.current.intensity, moved.position);
  const float difference = now - (pair.gain * before + pair.offset);
  const cv::Vec2f& gradient = hypotheses.gradient[i];
  const float slope = 2 * std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1]);
  return difference * difference > kMaxDifference * kMaxDifference + 0.25F * slope * slope;
}

/// Puts a moved hypothesis at an edge pixel of the next anchor, or settles who stays there.
void settle(const Hypotheses& from, std::size_t i, const MovedDepth& moved, std::size_t j,
            Hypotheses& next, PropagationCounts& counts) {
  constexpr float kMinShare = 0.8F;  // of a variance: two copies of one measurement are not two
  const auto put = [&] {
    next.set(j, moved.inverse_depth, moved.variance);
    next.knowledge[j] = from.knowledge[i];
    next.inliers[j] = from.inliers[i];
    next.outliers[j] = from.outliers[i];
  };
  ++counts.moved;
  if (next.knowledge[j] == Knowledge::none) {
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
  next.knowledge[j] = std::max(next.knowledge[j], from.knowledge[i]);
  next.inliers[j] = std::max(next.inliers[j], from.inliers[i]);
  next.outliers[j] = std::min(next.outliers[j], from.outliers[i]);
}

}  // namespace

MovedDepth moved_depth(const StereoPair& pair, const Eigen::Vector2f& ray, float inverse_depth,
                       float variance, float relative_noise) {
  const Eigen::Vector3f P =
      pair.R_cur_anchor * ray.homogeneous() + inverse_depth * pair.t_cur_anchor;
  constexpr float kMinDepthRatio = 0.01F;
  if (!(P.z() > kMinDepthRatio)) {
    return {};
  }
  const float d = inverse_depth / P.z();
  // d d'/d d = (R ray)_z / P_z^2: equal to (d'/d)^2 where the camera does not turn.
  const float growth = (P.z() - inverse_depth * pair.t_cur_anchor.z()) / (P.z() * P.z());
  const float noise = relative_noise * d;
  return {d, growth * growth * variance + noise * noise, P.hnormalized()};
}

PropagationCounts propagate(const StereoPair& pair, const Hypotheses& hypotheses,
                            const DepthMapOptions& options, Hypotheses& next) {
  PropagationCounts counts;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.knowledge[i] == Knowledge::none) {
      continue;
    }
    const MovedEdge moved = move_edge(pair, hypotheses, i, options);
    if (!(moved.depth.inverse_depth > 0) ||
        !can_be_sampled(pair.current.intensity, moved.position)) {
      ++counts.out_of_view;
      continue;
    }
    if (looks_different(pair, hypotheses, i, moved)) {
      ++counts.occluded;
      continue;
    }
    const int j = nearest_edge(next, moved);
    if (j < 0) {
      ++counts.without_edge;
      continue;
    }
    settle(hypotheses, i, moved.depth, static_cast<std::size_t>(j), next, counts);
  }
  return counts;
}

}  // namespace vo
