#pragma once

#include <string>

#include "tools/plot/plot.h"

namespace tools {

/// The maps from a panel's values to positions, px from the upper left corner of the area between
/// its axes.
struct PlotFrame {
  AxisMap x;
  AxisMap y;
};

/// Returns whether a point has a place on the panel's axes.
bool is_drawable(const PlotPanel& panel, const PlotPoint& point);

/// Returns the panel's cells and series.
std::string draw_marks(const PlotPanel& panel, const PlotFrame& frame);

/// Returns a series' entry in a legend, 26 px wide, with its left end in (x, y).
std::string draw_sample(const PlotSeries& series, double x, double y);

/// Returns the colour of a share of a range, 0..1; grey where it is not finite.
std::string map_colour(double share);

}  // namespace tools
