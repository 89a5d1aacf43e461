#include "vo/mapping/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "vo/mapping/depth_map_options.h"

namespace vo {
namespace {

constexpr int kMaxReach = 5;         // px along the chain to either side
constexpr double kFillSigma = 0.05;  // relative, of a pixel filled from its neighbours

/// The trusted neighbours of a pixel along its edge.
struct ChainNeighbours {
  std::array<std::size_t, 2 * kMaxReach> indices{};
  std::size_t count = 0;
};

ChainNeighbours neighbours_of(const Hypotheses& hypotheses, std::size_t i, int reach) {
  ChainNeighbours neighbours;
  for (const std::vector<int>* link : {&hypotheses.previous, &hypotheses.next}) {
    int at = (*link)[i];
    for (int step = 0; step < reach && at >= 0 && at != static_cast<int>(i); ++step) {
      const auto index = static_cast<std::size_t>(at);
      if (hypotheses.is_trusted(index)) {
        neighbours.indices[neighbours.count++] = index;
      }
      at = (*link)[index];
    }
  }
  return neighbours;
}

bool agree(const Hypotheses& hypotheses, std::size_t i, std::size_t j, float sigmas) {
  const float difference = hypotheses.inverse_depth[i] - hypotheses.inverse_depth[j];
  return difference * difference <=
         sigmas * sigmas * (hypotheses.variance[i] + hypotheses.variance[j]);
}

/// The weighted sums of a line fit of inverse depths over distances along the edge.
struct LineSums {
  float weight = 0;
  float distance = 0;
  float distance2 = 0;
  float difference = 0;
  float product = 0;

  void add(float w, float t, float d) {
    weight += w;
    distance += w * t;
    distance2 += w * t * t;
    difference += w * d;
    product += w * t * d;
  }
};

/// Smooths one inverse depth. Along the image of a straight edge inverse depths change linearly, so
/// a line is fitted through the neighbours that agree and taken at the hypothesis itself. A prior
/// makes steep lines unlikely. As aliasing gives neighbours similar errors, not all averages out.
void smooth_along_chain(const std::vector<float>& weights, std::size_t i, Hypotheses& hypotheses) {
  constexpr float kSlope = 0.004F;  // relative per px, prior standard deviation of the slope
  constexpr float kAgree = 3;       // standard deviations
  constexpr float kAlike = 0.4F;    // share of the variance that neighbours have in common
  const float d = hypotheses.inverse_depth[i];
  const float variance = hypotheses.variance[i];
  const float slope_variance = kSlope * kSlope * d * d;
  const cv::Vec2f& across = hypotheses.across[i];
  LineSums sums{.weight = weights[i], .distance2 = 1 / slope_variance};
  const ChainNeighbours neighbours = neighbours_of(hypotheses, i, kMaxReach);
  for (std::size_t n = 0; n < neighbours.count; ++n) {
    const std::size_t j = neighbours.indices[n];
    const cv::Point away = hypotheses.pixel[j] - hypotheses.pixel[i];
    const float t = static_cast<float>(away.y) * across[0] - static_cast<float>(away.x) * across[1];
    const float difference = hypotheses.inverse_depth[j] - d;
    const float expected = variance + hypotheses.variance[j] + slope_variance * t * t;
    if (difference * difference <= kAgree * kAgree * expected) {
      sums.add(weights[j], t, difference);
    }
  }
  const float determinant = sums.distance2 * sums.weight - sums.distance * sums.distance;
  const float fitted =
      d + (sums.distance2 * sums.difference - sums.distance * sums.product) / determinant;
  if (!(fitted > 0)) {
    return;
  }
  hypotheses.smoothed[i] = fitted;
  hypotheses.smoothed_variance[i] = kAlike * variance + (1 - kAlike) * sums.distance2 / determinant;
}

bool is_lonely(const Hypotheses& hypotheses, std::size_t i) {
  constexpr std::size_t kWitnesses = 3;
  constexpr float kFar = 0.05F;  // share of the inverse depth
  constexpr int kReach = 2;      // px
  const ChainNeighbours neighbours = neighbours_of(hypotheses, i, kReach);
  if (neighbours.count < kWitnesses) {
    return false;
  }
  const std::size_t first = neighbours.indices[0];
  for (std::size_t n = 0; n < neighbours.count; ++n) {
    const std::size_t j = neighbours.indices[n];
    const float distance = std::abs(hypotheses.inverse_depth[i] - hypotheses.inverse_depth[j]);
    if (!agree(hypotheses, first, j, 2) || agree(hypotheses, i, j, 3) ||
        distance < kFar * hypotheses.inverse_depth[i]) {
      return false;
    }
  }
  return true;
}

/// Returns the mean inverse depth of confident pixels in 5x5 if at least two and all agree, else 0.
float mean_around(const Hypotheses& hypotheses, cv::Point pixel) {
  constexpr int kRadius = 2;
  constexpr float kSpread = 1.1F;
  float sum = 0;
  float least = 0;
  float greatest = 0;
  int count = 0;
  for (int dv = -kRadius; dv <= kRadius; ++dv) {
    for (int du = -kRadius; du <= kRadius; ++du) {
      const int other = hypotheses.index(pixel + cv::Point(du, dv));
      const auto j = static_cast<std::size_t>(std::max(other, 0));
      if (other < 0 || hypotheses.state[j] != DepthState::known ||
          hypotheses.relative_sigma(j) > kConfidentSigma) {
        continue;
      }
      const float d = hypotheses.inverse_depth[j];
      least = count == 0 ? d : std::min(least, d);
      greatest = std::max(greatest, d);
      sum += d;
      ++count;
    }
  }
  return count >= 2 && greatest < kSpread * least ? sum / static_cast<float>(count) : 0;
}

}  // namespace

void smooth_along_chains(Hypotheses& hypotheses) {
  hypotheses.smoothed = hypotheses.inverse_depth;
  hypotheses.smoothed_variance = hypotheses.variance;
  std::vector<float> weights;
  weights.reserve(hypotheses.size());
  for (const float variance : hypotheses.variance) {
    weights.push_back(1 / variance);
  }
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.state[i] != DepthState::none) {
      smooth_along_chain(weights, i, hypotheses);
    }
  }
}

std::size_t forget_lonely(float guess, Hypotheses& hypotheses) {
  std::vector<std::size_t> lonely;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.state[i] == DepthState::known &&
        hypotheses.relative_sigma(i) <= kConfidentSigma && is_lonely(hypotheses, i)) {
      lonely.push_back(i);
    }
  }
  for (const std::size_t i : lonely) {
    hypotheses.forget(i, guess);
  }
  return lonely.size();
}

std::size_t fill_from_neighbours(Hypotheses& hypotheses) {
  std::vector<std::pair<std::size_t, float>> filled;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (hypotheses.state[i] == DepthState::none) {
      const float mean = mean_around(hypotheses, hypotheses.pixel[i]);
      if (mean > 0) {
        filled.emplace_back(i, mean);
      }
    }
  }
  for (const auto& [i, mean] : filled) {
    const float sigma = static_cast<float>(kFillSigma) * mean;
    hypotheses.set(i, mean, sigma * sigma);
    hypotheses.state[i] = DepthState::filled;
  }
  return filled.size();
}

}  // namespace vo
