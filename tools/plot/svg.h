#pragma once

#include <array>
#include <string>
#include <vector>

namespace tools {

/// A point in a drawing, px from its origin.
using SvgPoint = std::array<double, 2>;

/// Returns an estimate of a text's width, px, that is rather too wide.
double text_width(const std::string& text, double height_px = 12);

std::string px(double value);  ///< the value with one decimal, px

/// Returns a text, escaped, with its baseline at (x, y), turned about that point counterclockwise,
/// nothing for an empty one; `anchor`: start | middle | end.
std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const std::string& attributes = "", double turn_deg = 0);

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes);

std::string polyline(const std::vector<SvgPoint>& points, const std::string& attributes);

std::string rectangle(double x, double y, double width, double height, const std::string& colour);

}  // namespace tools
