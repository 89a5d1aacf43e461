#include "tools/plot/trajectory_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tools/plot/svg.h"
#include "tools/plot/svg_axis.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr double kWidth = 860;        // px
constexpr double kMapHeight = 520;    // px
constexpr double kErrorHeight = 200;  // px
constexpr double kMargin = 60;        // px

constexpr const char* kTrajectoryStyle =
    "<style>text{font:12px sans-serif;fill:#333}.axis{stroke:#ccc;stroke-width:1}"
    ".truth{stroke:#999;stroke-width:4;fill:none;stroke-linejoin:round}"
    ".error{stroke:#b2182b;stroke-width:1.5;fill:none}</style>\n";

/// The two world axes that are drawn to the right and upwards.
struct View {
  int right = 0;
  int up = 1;
};

/// Returns the two axes along which the trajectory extends most, in their order x, y, z.
View widest_view(const std::array<Range, 3>& extent) {
  int least = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (extent.at(static_cast<std::size_t>(axis)).size() <
        extent.at(static_cast<std::size_t>(least)).size()) {
      least = axis;
    }
  }
  return {least == 0 ? 1 : 0, least == 2 ? 1 : 2};
}

/// Maps metres to pixels with the same scale on both axes.
struct MapFrame {
  View view;
  AxisMap x;
  AxisMap y;

  SvgPoint operator()(const vo::StampedPose& pose) const {
    const Eigen::Vector3d& p = pose.T_world_camera.translation();
    return {x(p[view.right]), y(p[view.up])};
  }
};

MapFrame make_frame(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<Range, 3> extent;
  extent.fill({kInfinity, -kInfinity});
  for (const vo::Trajectory* trajectory : {&truth, &estimate}) {
    for (const vo::StampedPose& pose : *trajectory) {
      for (int axis = 0; axis < 3; ++axis) {
        extent.at(static_cast<std::size_t>(axis)).include(pose.T_world_camera.translation()[axis]);
      }
    }
  }
  const View view = widest_view(extent);
  const Range& across = extent.at(static_cast<std::size_t>(view.right));
  const Range& along = extent.at(static_cast<std::size_t>(view.up));
  const double inner_width = kWidth - 2 * kMargin;
  const double inner_height = kMapHeight - 2 * kMargin;
  const double m_per_px =
      std::max({across.size() / inner_width, along.size() / inner_height, 1e-6});
  const auto widened = [&](const Range& range, double pixels) {
    const double middle = (range.low + range.high) / 2;
    return Range{middle - m_per_px * pixels / 2, middle + m_per_px * pixels / 2};
  };
  return {view,
          {widened(across, inner_width), kMargin, kWidth - kMargin},
          {widened(along, inner_height), kMapHeight - kMargin, kMargin}};
}

/// Returns a colour from blue (0) over yellow to red (1).
std::string error_colour(double fraction) {
  const double hue = 240 * (1 - std::clamp(fraction, 0.0, 1.0));
  return vo::concat("hsl(", px(hue), ",85%,42%)");
}

/// Returns each pose's distance from the truth at its time, empty where the truth has no pose.
std::vector<std::optional<double>> position_errors(const vo::Trajectory& truth,
                                                   const vo::Trajectory& estimate) {
  std::vector<std::optional<double>> errors;
  for (const vo::StampedPose& pose : estimate) {
    const auto T_world_true = vo::pose_at(truth, pose.timestamp);
    errors.emplace_back();
    if (T_world_true) {
      errors.back() = (T_world_true->translation() - pose.T_world_camera.translation()).norm();
    }
  }
  return errors;
}

/// Returns the part of `truth` within the estimate's time span.
vo::Trajectory during(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  vo::Trajectory part;
  for (const vo::StampedPose& pose : truth) {
    if (pose.timestamp >= estimate.front().timestamp &&
        pose.timestamp <= estimate.back().timestamp) {
      part.push_back(pose);
    }
  }
  return part;
}

double greatest(const std::vector<std::optional<double>>& errors) {
  double result = 0;
  for (const auto& error : errors) {
    result = std::max(result, error.value_or(0));
  }
  return result;
}

std::string draw_estimate(const MapFrame& frame, const vo::Trajectory& estimate,
                          const std::vector<std::optional<double>>& errors, double scale) {
  std::string text;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    const auto [x1, y1] = frame(estimate[i - 1]);
    const auto [x2, y2] = frame(estimate[i]);
    const std::string colour =
        errors[i] ? error_colour(scale > 0 ? *errors[i] / scale : 0) : "#333";
    text += line(x1, y1, x2, y2,
                 vo::concat("stroke=\"", colour, "\" stroke-width=\"2\" stroke-linecap=\"round\""));
  }
  return text;
}

std::string draw_legend(double scale) {
  std::string text = line(kMargin, 22, kMargin + 30, 22, "class=\"truth\"") +
                     text_at(kMargin + 38, 26, "start", "truth");
  constexpr int kSteps = 24;
  constexpr double kBarWidth = 120;
  const double left = kMargin + 110;
  for (int i = 0; i < kSteps; ++i) {
    text += vo::concat("<rect x=\"", px(left + kBarWidth * i / kSteps), "\" y=\"16\" width=\"",
                       px(kBarWidth / kSteps + 0.5), "\" height=\"12\" fill=\"",
                       error_colour((i + 0.5) / kSteps), "\"/>\n");
  }
  std::array<char, 64> label{};
  std::snprintf(label.data(), label.size(), "estimate, error 0 to %.4g mm", 1000 * scale);
  return text + text_at(left + kBarWidth + 8, 26, "start", label.data());
}

std::string draw_error_plot(const vo::Trajectory& estimate,
                            const std::vector<std::optional<double>>& errors, double scale) {
  const double top = kMapHeight + kMargin / 4;
  const double start = estimate.front().timestamp;
  const AxisMap x{{0, estimate.back().timestamp - start}, kMargin, kWidth - kMargin};
  const AxisMap y{{0, 1000 * scale}, kMapHeight + kErrorHeight - kMargin, top};
  std::vector<SvgPoint> points;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i]) {
      points.push_back({x(estimate[i].timestamp - start), y(1000 * *errors[i])});
    }
  }
  return draw_x_axis(x, y, "time, s") + draw_y_axis(x, y, "error, mm") +
         polyline(points, "class=\"error\"");
}

}  // namespace

std::string draw_trajectory(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  vo::require(!estimate.empty(), "an empty trajectory cannot be drawn");
  const vo::Trajectory covered = during(truth, estimate);
  const MapFrame frame = make_frame(covered, estimate);
  const std::vector<std::optional<double>> errors = position_errors(truth, estimate);
  const double scale = greatest(errors);
  constexpr std::array kAxisNames{"x, m", "y, m", "z, m"};

  std::string svg =
      vo::concat("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", kWidth, "\" height=\"",
                 kMapHeight + kErrorHeight,
                 "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n", kTrajectoryStyle);
  svg += draw_x_axis(frame.x, frame.y, kAxisNames.at(static_cast<std::size_t>(frame.view.right)));
  svg += draw_y_axis(frame.x, frame.y, kAxisNames.at(static_cast<std::size_t>(frame.view.up)));
  std::vector<SvgPoint> truth_points;
  for (const vo::StampedPose& pose : covered) {
    truth_points.push_back(frame(pose));
  }
  svg += polyline(truth_points, "class=\"truth\"") + draw_estimate(frame, estimate, errors, scale);
  if (!truth.empty()) {
    svg += draw_legend(scale) + draw_error_plot(estimate, errors, scale);
  }
  return svg + "</svg>\n";
}

}  // namespace tools
