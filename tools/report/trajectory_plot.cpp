#include "tools/report/trajectory_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "tools/plot/plot.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr double kPlotWidth = 700;  // px, between the axes' ends

/// Distances of an estimate from the truth in a unit that suits them.
struct Distances {
  std::vector<double> values;  ///< one per pose, NaN where there is no truth
  double greatest = std::numeric_limits<double>::quiet_NaN();
  std::string title = "distance from the truth, m";
};

Distances distances_from(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  Distances distances;
  for (const vo::StampedPose& pose : estimate) {
    const auto T_world_true = vo::pose_at(truth, pose.timestamp);
    distances.values.push_back(
        T_world_true ? (T_world_true->translation() - pose.T_world_camera.translation()).norm()
                     : std::numeric_limits<double>::quiet_NaN());
    distances.greatest = std::fmax(distances.greatest, distances.values.back());
  }
  if (distances.greatest < 1) {
    constexpr double kMillimetres = 1000;
    for (double& value : distances.values) {
      value *= kMillimetres;
    }
    distances.greatest *= kMillimetres;
    distances.title = "distance from the truth, mm";
  }
  return distances;
}

/// Returns the positions, seen along the world axis in which they extend least, and the truth as
/// far as the estimate's time goes.
PlotPanel positions_panel(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  vo::Trajectory covered;
  std::copy_if(truth.begin(), truth.end(), std::back_inserter(covered), [&](const auto& pose) {
    return pose.timestamp >= estimate.front().timestamp &&
           pose.timestamp <= estimate.back().timestamp;
  });
  vo::Trajectory shown = covered;
  shown.insert(shown.end(), estimate.begin(), estimate.end());
  Eigen::AlignedBox3d box;
  for (const vo::StampedPose& pose : shown) {
    box.extend(pose.T_world_camera.translation());
  }
  Eigen::Index least = 0;
  box.sizes().minCoeff(&least);
  const Eigen::Index right = least == 0 ? 1 : 0;
  const Eigen::Index up = least == 2 ? 1 : 2;
  const auto series_of = [&](const char* name, int style, PlotMark mark, const auto& trajectory) {
    PlotSeries series{name, style, mark, {}};
    for (const vo::StampedPose& pose : trajectory) {
      const Eigen::Vector3d& p_world = pose.T_world_camera.translation();
      series.points.push_back({p_world[right], p_world[up]});
    }
    return series;
  };
  constexpr std::array kTitles{"x, m", "y, m", "z, m"};
  return {.x = {.title = kTitles.at(static_cast<std::size_t>(right))},
          .y = {.title = kTitles.at(static_cast<std::size_t>(up))},
          .series = {series_of("truth", 2, PlotMark::broad_line, covered),
                     series_of("estimate", 0, PlotMark::line, estimate)},
          .has_equal_scales = true,
          .width = kPlotWidth,
          .height = 400};
}

/// Shows the distances as colours of the estimate.
void add_colours(const Distances& distances, PlotPanel& positions) {
  PlotSeries& series = positions.series[1];
  series.mark = PlotMark::coloured_line;
  for (std::size_t i = 0; i < distances.values.size(); ++i) {
    series.points[i].value = distances.values[i];
    if (std::isnan(distances.values[i])) {
      series.name = "estimate (grey: there is no truth)";
    }
  }
  constexpr double kLeast = 1e-6;  // m or mm, below which errors are those of rounding
  positions.colours = {.title = distances.title,
                       .range = {0, std::max(distances.greatest, kLeast)}};
}

PlotPanel distances_panel(const vo::Trajectory& estimate, const Distances& distances) {
  PlotPanel panel{.x = {.title = "time, s"},
                  .y = {.title = distances.title, .include = {0, 1e-6}},
                  .series = {{"", 0, PlotMark::line, {}}},
                  .width = kPlotWidth,
                  .height = 160};
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    panel.series[0].points.push_back(
        {estimate[i].timestamp - estimate.front().timestamp, distances.values[i]});
  }
  return panel;
}

}  // namespace

std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                            vo::TrajectoryAlignment alignment) {
  vo::require(!estimate.empty(), "an empty trajectory cannot be drawn");
  PlotPanel positions = positions_panel(truth, estimate);
  const Distances distances = distances_from(truth, estimate);
  if (std::isnan(distances.greatest)) {
    positions.series.erase(positions.series.begin());
    return draw_plot("Trajectory", {positions});
  }
  add_colours(distances, positions);
  const std::string how = alignment == vo::TrajectoryAlignment::none
                              ? "not aligned to the truth"
                              : vo::concat("aligned to the truth (", vo::to_string(alignment), ")");
  return draw_plot("Trajectory, " + how, {positions, distances_panel(estimate, distances)},
                   PlotLayout::stacked);
}

}  // namespace tools
