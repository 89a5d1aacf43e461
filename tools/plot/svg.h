#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/plot/svg_axis.h"

namespace tools {

/// A point in a drawing, px from its top-left corner.
using SvgPoint = std::array<double, 2>;

std::string px(double value);  ///< the value with one decimal, px

/// Returns a text element with its baseline at (x, y); `anchor`: start | middle | end.
std::string text_at(double x, double y, const char* anchor, const std::string& text);

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes);

std::string polyline(const std::vector<SvgPoint>& points, const std::string& attributes);

/// Returns the grid lines (class "axis") of one axis, labels at its ticks, and its title: that of x
/// is below, that of y above.
std::string draw_x_axis(const AxisMap& x, const AxisMap& y, const std::string& title);
std::string draw_y_axis(const AxisMap& x, const AxisMap& y, const std::string& title);

}  // namespace tools
