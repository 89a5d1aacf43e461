#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/plot/svg_axis.h"

namespace tools {

struct PlotPoint {
  double x = 0;
  double y = 0;
  double deviation = 0;  ///< half length of the error bar; 0 = none
  double value = 0;      ///< what a coloured line shows
};

enum class PlotMark {
  line,             ///< line through the points
  dashes,           ///< dashed line through the points
  broad_line,       ///< broad, pale line through the points, for what lies beneath others
  coloured_line,    ///< line, each piece in the colour of the value at its end; grey = not finite
  points,           ///< only markers
  line_and_points,  ///< line through the points, with markers
  bar,              ///< bar from 0 to y; bars of several series are side by side
};

/// A series of points. Its style determines colour and marker; equal names share a legend entry.
struct PlotSeries {
  std::string name;  ///< name in the legend; empty = none
  int style = 0;     ///< index into the palette
  PlotMark mark = PlotMark::line_and_points;
  std::vector<PlotPoint> points;
};

struct PlotAxis {
  std::string title;  ///< axis title with unit
  AxisScale scale = AxisScale::linear;
  Range include = {};  ///< range that is always shown; empty = fitted to the values
  std::vector<std::string> categories = {};  ///< labels of 0, 1, ...
};

/// Values on a grid of categories, each a coloured cell with its number.
struct PlotCells {
  std::vector<std::vector<double>> values;  ///< values[i][j] at y = i, x = j; NaN is blank
  int decimals = 0;
};

/// The meaning of a panel's colours, which a bar to its right shows: dark is low, light is high.
struct PlotColours {
  std::string title;  ///< title with unit
  Range range;        ///< range that the colours span; values beyond have the colours of its ends
  AxisScale scale = AxisScale::linear;
};

/// One pair of axes and all that is drawn between them.
struct PlotPanel {
  PlotAxis x = {};
  PlotAxis y = {};
  std::vector<PlotSeries> series = {};
  PlotCells cells = {};
  std::optional<PlotColours> colours = {};  ///< needed by cells and coloured lines
  bool has_equal_scales = false;            ///< a unit is as long on the one axis as on the other
  double width = 382;   ///< px between the axes' ends; more where titles need it
  double height = 254;  ///< px
};

enum class PlotLayout { side_by_side, stacked };

/// Returns an SVG with the panels below a title and one legend for all. Values that are not finite
/// (or, on logarithmic axes, not positive) are left out.
std::string draw_plot(const std::string& title, const std::vector<PlotPanel>& panels,
                      PlotLayout layout = PlotLayout::side_by_side);

}  // namespace tools
