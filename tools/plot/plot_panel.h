#pragma once

#include <string>

#include "tools/plot/plot.h"

namespace tools {

/// A panel as it is drawn, and what it takes, px from the upper left corner of the area between its
/// axes, which is its origin.
struct DrawnPanel {
  std::string svg;
  double left = 50;   ///< to the left end of its labels
  double above = 30;  ///< to the upper end of its title
  double right = 0;   ///< to the right end of its colour bar
  double below = 0;   ///< to the lower end of its labels
};

/// Returns the panel's axes, marks and colour bar.
DrawnPanel draw_panel(PlotPanel panel);

}  // namespace tools
