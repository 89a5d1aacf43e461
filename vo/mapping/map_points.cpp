#include "vo/mapping/map_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {
namespace {

/// A pixel of one level and what is known of its depth.
struct SparseDepth {
  cv::Point pixel;
  float inverse_depth = 0;  ///< 1/m
  float variance = 0;       ///< 1/m^2
};

std::vector<SparseDepth> finest_depths(const Hypotheses& hypotheses, double max_sigma,
                                       Guesses guesses) {
  std::vector<SparseDepth> depths;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const bool is_guess = !hypotheses.is_trusted(i);
    if (is_guess ? guesses == Guesses::included : hypotheses.is_confident(i, max_sigma)) {
      depths.push_back(
          {hypotheses.pixel[i], hypotheses.smoothed[i], hypotheses.smoothed_variance[i]});
    }
  }
  return depths;
}

/// What two depths in one pixel say together: their mean where they agree, else the nearer one.
SparseDepth together(const SparseDepth& a, const SparseDepth& b) {
  constexpr float kSameSurface = 1.05F;
  const SparseDepth& nearer = a.inverse_depth >= b.inverse_depth ? a : b;
  const SparseDepth& farther = a.inverse_depth >= b.inverse_depth ? b : a;
  if (nearer.inverse_depth > kSameSurface * farther.inverse_depth) {
    return nearer;
  }
  const float share = b.variance / (a.variance + b.variance);
  return {a.pixel, share * a.inverse_depth + (1 - share) * b.inverse_depth,
          std::min(a.variance, b.variance)};
}

/// The depths at half the resolution, in scan order.
std::vector<SparseDepth> halved(const std::vector<SparseDepth>& depths, cv::Size size) {
  cv::Mat_<int> index(size, -1);
  std::vector<SparseDepth> cells;
  for (SparseDepth depth : depths) {
    depth.pixel = {depth.pixel.x / 2, depth.pixel.y / 2};
    if (depth.pixel.x >= size.width || depth.pixel.y >= size.height) {
      continue;
    }
    int& cell = index(depth.pixel);
    if (cell < 0) {
      cell = static_cast<int>(cells.size());
      cells.push_back(depth);
    } else {
      SparseDepth& known = cells[static_cast<std::size_t>(cell)];
      known = together(known, depth);
    }
  }
  std::sort(cells.begin(), cells.end(), [](const SparseDepth& a, const SparseDepth& b) {
    return std::pair(a.pixel.y, a.pixel.x) < std::pair(b.pixel.y, b.pixel.x);
  });
  return cells;
}

}  // namespace

EdgePoints map_points(const FramePyramid& anchor, const Hypotheses& hypotheses,
                      const EdgePointOptions& options, double max_sigma, Guesses guesses) {
  EdgePoints points;
  std::vector<SparseDepth> depths = finest_depths(hypotheses, max_sigma, guesses);
  for (std::size_t l = 0; l < anchor.levels.size(); ++l) {
    const PyramidLevel& level = anchor.levels[l];
    if (l > 0) {
      depths = halved(depths, level.intensity.size());
    }
    const Thinning thinning(options.at_level(l), depths.size(), level.intensity.cols);
    std::vector<PixelDepth> kept;
    for (const SparseDepth& depth : depths) {
      const float z = 1 / depth.inverse_depth;
      if (z >= options.min_depth && z <= options.max_depth && thinning.keeps(depth.pixel)) {
        kept.push_back({depth.pixel, z, std::sqrt(depth.variance) * z * z});
      }
    }
    points.levels.push_back(points_at(level, kept, available_instruction_set()));
  }
  return points;
}

}  // namespace vo
