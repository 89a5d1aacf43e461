#pragma once

#include <string>
#include <vector>

#include "tools/plot/svg_axis.h"

namespace tools {

/// Values on a grid, each shown as a coloured cell with its number.
struct HeatMap {
  std::string title;  ///< title of the map with the values' unit
  std::string x_title;
  std::string y_title;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<std::vector<double>> values;  ///< values[i][j] at y[i], x[j]; NaN is blank
  Range range;                              ///< range of values that the colours span
  AxisScale scale = AxisScale::linear;      ///< scale of the colours
  int decimals = 0;
};

/// Returns an SVG with the maps side by side. Dark is low, light is high.
std::string draw_heat_maps(const std::string& title, const std::vector<HeatMap>& maps);

}  // namespace tools
