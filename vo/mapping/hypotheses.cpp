#include "vo/mapping/hypotheses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "vo/core/hash.h"
#include "vo/core/median.h"
#include "vo/core/pixel_bits.h"
#include "vo/mapping/stereo_pair.h"

namespace vo {
namespace {

constexpr int kBorder = 4;  // px; leaves room for the samples along a line

/// Returns where the gradient along its direction is greatest, px: the vertex of a parabola through
/// three slopes.
float offset_of_edge(const GrayImage& image, cv::Point pixel, cv::Vec2f direction) {
  constexpr float kMaxOffset = 0.7F;
  std::array<float, 5> along{};
  for (std::size_t i = 0; i < along.size(); ++i) {
    const float step = static_cast<float>(i) - 2;
    along[i] = sample_bilinear(image, {static_cast<float>(pixel.x) + step * direction[0],
                                       static_cast<float>(pixel.y) + step * direction[1]});
  }
  const float before = along[2] - along[0];
  const float at = along[3] - along[1];
  const float after = along[4] - along[2];
  const float bend = before - 2 * at + after;
  return bend < 0 ? std::clamp(0.5F * (before - after) / bend, -kMaxOffset, kMaxOffset) : 0;
}

/// Returns whether a pixel is in the share that is kept: whole blocks, so that chains stay whole.
bool is_kept(cv::Point pixel, double share, std::uint64_t seed) {
  constexpr int kBlock = 8;  // px
  const auto block = static_cast<std::uint64_t>(pixel.y / kBlock) * 65536 +
                     static_cast<std::uint64_t>(pixel.x / kBlock);
  return mixed_uniform(mixed(seed) + block) < share;
}

void add_hypothesis(const PyramidLevel& level, cv::Point pixel, Hypotheses& hypotheses) {
  const cv::Vec2f gradient = central_gradient(level.intensity, pixel);
  const float norm = std::hypot(gradient[0], gradient[1]);
  if (!(norm > 0)) {
    return;
  }
  hypotheses.index(pixel) = static_cast<int>(hypotheses.size());
  hypotheses.pixel.push_back(pixel);
  hypotheses.ray.push_back(level.rays(pixel));
  hypotheses.gradient.push_back(gradient);
  hypotheses.across.push_back(gradient / norm);
  hypotheses.edge_offset.push_back(offset_of_edge(level.intensity, pixel, gradient / norm));
}

/// Sets all depths to a guess of inverse depth, 1/m, with nothing known.
void guess_depths(float guess, Hypotheses& hypotheses) {
  const std::size_t count = hypotheses.size();
  hypotheses.state.assign(count, DepthState::none);
  for (std::vector<float>* depth : {&hypotheses.inverse_depth, &hypotheses.smoothed}) {
    depth->assign(count, guess);
  }
  for (std::vector<float>* variance : {&hypotheses.variance, &hypotheses.smoothed_variance}) {
    variance->assign(count, guess * guess);
  }
  hypotheses.offset_variance.assign(count, 1);
  for (std::vector<float>* none : {&hypotheses.offset, &hypotheses.offset_covariance,
                                   &hypotheses.inliers, &hypotheses.outliers}) {
    none->assign(count, 0);
  }
}

/// Returns the neighbour of pixel i that continues the edge to one side (+1 or -1), or -1.
int neighbour_along(const Hypotheses& hypotheses, std::size_t i, float side) {
  constexpr float kMaxTurn = 0.7F;  // least cosine of the gradients of neighbouring pixels
  constexpr float kDiagonal = std::numbers::sqrt2_v<float>;
  const cv::Vec2f& across = hypotheses.across[i];
  const cv::Vec2f along(-side * across[1], side * across[0]);
  int best = -1;
  float best_cos = 0.5F;
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      const int other = hypotheses.index(hypotheses.pixel[i] + cv::Point(du, dv));
      if (other < 0 || (du == 0 && dv == 0)) {
        continue;
      }
      const cv::Vec2f step(static_cast<float>(du), static_cast<float>(dv));
      const float length = du != 0 && dv != 0 ? kDiagonal : 1;
      const float cosine = (step[0] * along[0] + step[1] * along[1]) / length;
      const cv::Vec2f& there = hypotheses.across[static_cast<std::size_t>(other)];
      const float turn = across[0] * there[0] + across[1] * there[1];
      if (cosine > best_cos && turn > kMaxTurn) {
        best_cos = cosine;
        best = other;
      }
    }
  }
  return best;
}

}  // namespace

cv::Vec2f Hypotheses::edge_position(std::size_t i) const {
  return {static_cast<float>(pixel[i].x) + edge_offset[i] * across[i][0],
          static_cast<float>(pixel[i].y) + edge_offset[i] * across[i][1]};
}

void Hypotheses::set(std::size_t i, float new_inverse_depth, float new_variance) {
  state[i] = DepthState::known;
  inverse_depth[i] = new_inverse_depth;
  smoothed[i] = new_inverse_depth;
  smoothed_variance[i] = new_variance;
  variance[i] = new_variance;
  offset[i] = 0;
  offset_variance[i] = 1;
  offset_covariance[i] = 0;
  inliers[i] = 0;
  outliers[i] = 0;
}

void Hypotheses::forget(std::size_t i, float guess) {
  set(i, guess, guess * guess);
  state[i] = DepthState::none;
}

Hypotheses edge_hypotheses(const PyramidLevel& level, const DepthMapOptions& options,
                           float guessed_inverse_depth) {
  const EdgeMask& edges = level.edges;
  Hypotheses hypotheses;
  hypotheses.index = cv::Mat_<int>(edges.size(), -1);
  const int count = cv::countNonZero(edges);
  const double share =
      options.max_hypotheses > 0 ? options.max_hypotheses / std::max(1.0, 1.0 * count) : 1;
  for (int v = kBorder; v < edges.rows - kBorder; ++v) {
    for_each_set(edges[v], edges.cols, [&](int u) {
      if (u >= kBorder && u < edges.cols - kBorder &&
          (share >= 1 || is_kept({u, v}, share, options.seed))) {
        add_hypothesis(level, {u, v}, hypotheses);
      }
    });
  }
  guess_depths(guessed_inverse_depth, hypotheses);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    hypotheses.previous.push_back(neighbour_along(hypotheses, i, -1));
    hypotheses.next.push_back(neighbour_along(hypotheses, i, 1));
  }
  return hypotheses;
}

float median_inverse_depth(const Hypotheses& hypotheses, float fallback) {
  std::vector<float> known;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.state[i] != DepthState::none) {
      known.push_back(hypotheses.inverse_depth[i]);
    }
  }
  return known.empty() ? fallback : upper_median(std::move(known));
}

}  // namespace vo
