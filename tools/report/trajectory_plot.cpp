#include "tools/report/trajectory_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "tools/plot/plot.h"
#include "tools/scenario/error_titles.h"
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

/// Returns the truth as far as the estimate's time goes.
vo::Trajectory during(const vo::Trajectory& estimate, const vo::Trajectory& truth) {
  vo::Trajectory covered;
  std::copy_if(truth.begin(), truth.end(), std::back_inserter(covered), [&](const auto& pose) {
    return pose.timestamp >= estimate.front().timestamp &&
           pose.timestamp <= estimate.back().timestamp;
  });
  return covered;
}

/// A plane of two world axes, seen against the third: with that towards the viewer the drawing is
/// not mirrored.
struct WorldPlane {
  Eigen::Index right = 0;
  Eigen::Index up = 1;

  std::string name() const { return vo::concat(kAxes.at(right), "-", kAxes.at(up), " plane"); }
  std::string title(Eigen::Index axis) const { return vo::concat(kAxes.at(axis), ", m"); }

  static constexpr std::array kAxes{"x", "y", "z"};
};

/// Returns the plane against whose axis the positions extend least.
WorldPlane widest_plane(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  Eigen::AlignedBox3d box;
  for (const vo::Trajectory* trajectory : {&truth, &estimate}) {
    for (const vo::StampedPose& pose : *trajectory) {
      box.extend(pose.T_world_camera.translation());
    }
  }
  Eigen::Index least = 0;
  box.sizes().minCoeff(&least);
  return {(least + 1) % 3, (least + 2) % 3};
}

/// Returns the positions in a plane of the world.
PlotPanel positions_panel(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                          const WorldPlane& plane) {
  const auto series_of = [&](const char* name, int style, PlotMark mark, const auto& trajectory) {
    PlotSeries series{name, style, mark, {}};
    for (const vo::StampedPose& pose : trajectory) {
      const Eigen::Vector3d& p_world = pose.T_world_camera.translation();
      series.points.push_back({p_world[plane.right], p_world[plane.up]});
    }
    return series;
  };
  return {.x = {.title = plane.title(plane.right)},
          .y = {.title = plane.title(plane.up)},
          .series = {series_of("truth", 2, PlotMark::broad_line, truth),
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

std::string draw_alone(const vo::Trajectory& estimate) {
  const WorldPlane plane = widest_plane({}, estimate);
  PlotPanel positions = positions_panel({}, estimate, plane);
  positions.series.erase(positions.series.begin());
  return draw_plot("Trajectory in the " + plane.name() + " of its own world", {positions});
}

/// Returns how the estimate lies on the truth, for the title.
std::string placement_text(vo::TrajectoryAlignment alignment, bool has_matches) {
  if (alignment == vo::TrajectoryAlignment::none) {
    return alignment_text(alignment);
  }
  return has_matches ? alignment_text(alignment) + ", least squares"
                     : "not aligned: fewer than three poses match";
}

}  // namespace

std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                            vo::TrajectoryAlignment alignment) {
  vo::require(!estimate.empty(), "an empty trajectory cannot be drawn");
  const std::optional<vo::Trajectory> aligned =
      vo::align_trajectory(truth, estimate, {.alignment = alignment});
  const vo::Trajectory& shown = aligned ? *aligned : estimate;
  const Distances distances = distances_from(truth, shown);
  if (std::isnan(distances.greatest)) {
    return draw_alone(estimate);
  }
  const vo::Trajectory covered = during(estimate, truth);
  const WorldPlane plane = widest_plane(covered, shown);
  PlotPanel positions = positions_panel(covered, shown, plane);
  add_colours(distances, positions);
  return draw_plot(
      vo::concat("Trajectory in the ", plane.name(), " of the truth's world; estimate ",
                 placement_text(alignment, aligned.has_value())),
      {positions, distances_panel(shown, distances)}, PlotLayout::stacked);
}

}  // namespace tools
