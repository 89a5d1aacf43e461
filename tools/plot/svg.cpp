#include "tools/plot/svg.h"

#include <cstdio>

#include "vo/core/error.h"

namespace tools {

std::string px(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return vo::concat("<text x=\"", px(x), "\" y=\"", px(y), "\" text-anchor=\"", anchor, "\">", text,
                    "</text>\n");
}

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes) {
  return vo::concat("<line x1=\"", px(x1), "\" y1=\"", px(y1), "\" x2=\"", px(x2), "\" y2=\"",
                    px(y2), "\" ", attributes, "/>\n");
}

std::string polyline(const std::vector<SvgPoint>& points, const std::string& attributes) {
  std::string text = vo::concat("<polyline ", attributes, " points=\"");
  for (const auto& [x, y] : points) {
    text += px(x) + "," + px(y) + " ";
  }
  return text + "\"/>\n";
}

std::string draw_x_axis(const AxisMap& x, const AxisMap& y, const std::string& title) {
  std::string text;
  for (const double value : axis_ticks(x, 8)) {
    text += line(x(value), y.first_px, x(value), y.last_px, "class=\"axis\"");
    text += text_at(x(value), y.first_px + 16, "middle", tick_label(value));
  }
  return text + text_at((x.first_px + x.last_px) / 2, y.first_px + 34, "middle", title);
}

std::string draw_y_axis(const AxisMap& x, const AxisMap& y, const std::string& title) {
  std::string text;
  for (const double value : axis_ticks(y, 6)) {
    text += line(x.first_px, y(value), x.last_px, y(value), "class=\"axis\"");
    text += text_at(x.first_px - 6, y(value) + 4, "end", tick_label(value));
  }
  return text + text_at(x.first_px - 44, y.last_px - 10, "start", title);
}

}  // namespace tools
