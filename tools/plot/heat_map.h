#pragma once

#include <string>
#include <vector>

#include "tools/plot/svg_axis.h"

namespace tools {

/// Values on a grid, each a coloured cell with its number.
struct HeatMap {
  std::string title;  ///< of the values, with unit
  std::string x_title;
  std::string y_title;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<std::vector<double>> values;  ///< values[i][j] at y[i], x[j]; NaN is blank
  Range range;                              ///< of the colours
  AxisScale scale = AxisScale::linear;      ///< of the colours
  int decimals = 0;
};

/// The maps beside each other, as SVG. Dark is low, light is high.
std::string draw_heat_maps(const std::string& title, const std::vector<HeatMap>& maps);

}  // namespace tools
