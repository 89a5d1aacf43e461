#include "vo/mapping/nearest_edge.h"

#include <cmath>

namespace vo {
namespace {

constexpr float kSnapDistance = 1;   // px, distance across the edge
constexpr float kMaxTurn = 0.7071F;  // least cosine of the gradients in both images

}  // namespace

int nearest_edge(const Hypotheses& hypotheses, const MovedEdge& moved) {
  constexpr int kRadius = 1;
  const cv::Point centre(static_cast<int>(std::lround(moved.position.x())),
                         static_cast<int>(std::lround(moved.position.y())));
  int best = -1;
  float best_distance2 = 1e9F;
  for (int dv = -kRadius; dv <= kRadius; ++dv) {
    for (int du = -kRadius; du <= kRadius; ++du) {
      const int candidate = hypotheses.index(centre + cv::Point(du, dv));
      if (candidate < 0) {
        continue;
      }
      const auto j = static_cast<std::size_t>(candidate);
      const cv::Vec2f& across = hypotheses.across[j];
      const cv::Vec2f edge = hypotheses.edge_position(j);
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

}  // namespace vo
