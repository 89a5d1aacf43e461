#include "tools/plot/svg.h"

#include <cstdio>

#include "tools/plot/escaped_markup.h"
#include "vo/core/error.h"

namespace tools {

double text_width(const std::string& text, double height_px) {
  constexpr double kMeanCharacter = 0.6;  // of the height; most sans-serif fonts are narrower
  return kMeanCharacter * height_px * static_cast<double>(text.size());
}

std::string px(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const std::string& attributes, double turn_deg) {
  if (text.empty()) {
    return "";
  }
  return vo::concat("<text transform=\"translate(", px(x), " ", px(y), ") rotate(", px(-turn_deg),
                    ")\" text-anchor=\"", anchor, "\" ", attributes, ">", escaped_markup(text),
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

std::string rectangle(double x, double y, double width, double height, const std::string& colour) {
  return vo::concat("<rect x=\"", px(x), "\" y=\"", px(y), "\" width=\"", px(width), "\" height=\"",
                    px(height), "\" fill=\"", colour, "\"/>\n");
}

}  // namespace tools
