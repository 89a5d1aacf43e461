#pragma once

#include <string>
#include <vector>

#include "tools/plot/svg_axis.h"

namespace tools {

struct PlotPoint {
  double x = 0;
  double y = 0;
  double deviation = 0;  ///< drawn as a bar above and below; 0 = none
};

enum class PlotMark {
  line,             ///< through the points
  dashes,           ///< the same, dashed
  points,           ///< markers alone
  line_and_points,  ///< both
  bar,              ///< from 0 to y, bars of several series beside each other
};

/// Series of the same style have the same colour and marker in every panel, and one legend entry.
struct PlotSeries {
  std::string name;
  int style = 0;  ///< index into the palette
  PlotMark mark = PlotMark::line_and_points;
  std::vector<PlotPoint> points;
};

struct PlotAxis {
  std::string title;  ///< with unit
  AxisScale scale = AxisScale::linear;
  Range include = {};                   ///< shown whatever the values are; empty = as they are
  std::vector<std::string> categories;  ///< labels of x = 0, 1, ...
};

struct PlotPanel {
  PlotAxis x;
  PlotAxis y;
  std::vector<PlotSeries> series;
};

/// Panels beside each other below a title and one legend for all. Values that are not finite (or,
/// on logarithmic axes, not positive) are left out.
std::string draw_plot(const std::string& title, const std::vector<PlotPanel>& panels);

}  // namespace tools
