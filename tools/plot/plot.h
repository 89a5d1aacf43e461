#pragma once

#include <string>
#include <vector>

#include "tools/plot/svg_axis.h"

namespace tools {

struct PlotPoint {
  double x = 0;
  double y = 0;
  double deviation = 0;  ///< half length of the error bar; 0 = none
};

enum class PlotMark {
  line,             ///< line through the points
  dashes,           ///< dashed line through the points
  points,           ///< only markers
  line_and_points,  ///< line through the points, with markers
  bar,              ///< bar from 0 to y; bars of several series are side by side
};

/// A named series. Its style determines colour and marker; equal names share a legend entry.
struct PlotSeries {
  std::string name;
  int style = 0;  ///< index into the palette
  PlotMark mark = PlotMark::line_and_points;
  std::vector<PlotPoint> points;
};

struct PlotAxis {
  std::string title;  ///< axis title with unit
  AxisScale scale = AxisScale::linear;
  Range include = {};  ///< range that is always shown; empty = fitted to the values
  std::vector<std::string> categories;  ///< labels of x = 0, 1, ...
};

struct PlotPanel {
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSeries> series;
};

/// Returns an SVG with the panels side by side below a title and one legend for all. Values that
/// are not finite (or, on logarithmic axes, not positive) are left out.
std::string draw_plot(const std::string& title, const std::vector<PlotPanel>& panels);

}  // namespace tools
