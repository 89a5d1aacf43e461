#include "vo/mapping/map_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {
namespace {

/// The inverse depth of a cell and its variance.
struct CellDepth {
  float inverse_depth = 0;  ///< 1/m
  float variance = -1;      ///< 1/m^2; below 0 nothing is known

  bool is_known() const { return variance >= 0; }
};

std::vector<CellDepth> finest_depths(const Hypotheses& hypotheses, double max_sigma,
                                     Guesses guesses) {
  std::vector<CellDepth> depths(hypotheses.size());
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const bool is_guess = !hypotheses.is_trusted(i);
    if (is_guess ? guesses == Guesses::included : hypotheses.is_confident(i, max_sigma)) {
      depths[i] = {hypotheses.smoothed[i], hypotheses.smoothed_variance[i]};
    }
  }
  return depths;
}

/// Combines two depths in one pixel: their mean where they agree, else the nearer one.
CellDepth together(const CellDepth& a, const CellDepth& b) {
  constexpr float kSameSurface = 1.05F;
  const CellDepth& nearer = a.inverse_depth >= b.inverse_depth ? a : b;
  const CellDepth& farther = a.inverse_depth >= b.inverse_depth ? b : a;
  if (nearer.inverse_depth > kSameSurface * farther.inverse_depth) {
    return nearer;
  }
  const float share = b.variance / (a.variance + b.variance);
  return {share * a.inverse_depth + (1 - share) * b.inverse_depth,
          std::min(a.variance, b.variance)};
}

/// Returns the depths of the `count` cells at half the resolution.
std::vector<CellDepth> halved(const std::vector<PointCell>& cells,
                              const std::vector<CellDepth>& depths, std::size_t count) {
  std::vector<CellDepth> coarser(count);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (depths[i].is_known() && cells[i].parent >= 0) {
      CellDepth& above = coarser[static_cast<std::size_t>(cells[i].parent)];
      above = above.is_known() ? together(above, depths[i]) : depths[i];
    }
  }
  return coarser;
}

/// Returns the cells at half the resolution and sets the parents of `cells`.
std::vector<PointCell> cells_above(cv::Size size, std::vector<PointCell>& cells) {
  const cv::Rect inside({0, 0}, size);
  cv::Mat_<int> index(size, -1);
  std::vector<PointCell> coarser;
  for (const PointCell& cell : cells) {
    const cv::Point above = cell.pixel / 2;
    if (inside.contains(above) && std::exchange(index(above), 0) < 0) {
      coarser.push_back({above});
    }
  }
  std::sort(coarser.begin(), coarser.end(), [](const PointCell& a, const PointCell& b) {
    return std::pair(a.pixel.y, a.pixel.x) < std::pair(b.pixel.y, b.pixel.x);
  });
  for (std::size_t i = 0; i < coarser.size(); ++i) {
    index(coarser[i].pixel) = static_cast<int>(i);
  }
  for (PointCell& cell : cells) {
    const cv::Point above = cell.pixel / 2;
    cell.parent = inside.contains(above) ? index(above) : -1;
  }
  return coarser;
}

/// Returns the known depths that the options leave.
std::vector<PixelDepth> usable_depths(const std::vector<PointCell>& cells,
                                      const std::vector<CellDepth>& depths,
                                      const EdgePointOptions& options, int width) {
  const auto known = static_cast<std::size_t>(std::count_if(
      depths.begin(), depths.end(), [](const CellDepth& depth) { return depth.is_known(); }));
  const Thinning thinning(options, known, width);
  std::vector<PixelDepth> usable;
  usable.reserve(known);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const float z = 1 / depths[i].inverse_depth;
    if (depths[i].is_known() && z >= options.min_depth && z <= options.max_depth &&
        thinning.keeps(cells[i].pixel)) {
      usable.push_back({cells[i].pixel, z, std::sqrt(depths[i].variance) * z * z});
    }
  }
  return usable;
}

}  // namespace

PointCells point_cells(const FramePyramid& host, const Hypotheses& hypotheses) {
  PointCells cells(host.levels.size());
  for (const cv::Point pixel : hypotheses.pixel) {
    cells.front().push_back({pixel});
  }
  for (std::size_t l = 1; l < cells.size(); ++l) {
    cells[l] = cells_above(host.levels[l].intensity.size(), cells[l - 1]);
  }
  return cells;
}

EdgePoints map_points(const FramePyramid& host, const PointCells& cells,
                      const Hypotheses& hypotheses, const EdgePointOptions& options,
                      double max_sigma, Guesses guesses) {
  EdgePoints points;
  std::vector<CellDepth> depths = finest_depths(hypotheses, max_sigma, guesses);
  for (std::size_t l = 0; l < cells.size(); ++l) {
    if (l > 0) {
      depths = halved(cells[l - 1], depths, cells[l].size());
    }
    const PyramidLevel& level = host.levels[l];
    const std::vector<PixelDepth> usable =
        usable_depths(cells[l], depths, options.at_level(l), level.intensity.cols);
    show_points(level, usable, available_instruction_set(), points.levels.emplace_back());
  }
  return points;
}

}  // namespace vo
