#include "tools/plot/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tools/plot/svg.h"
#include "tools/plot/table.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr double kCell = 52;       // px
constexpr double kMapLeft = 70;    // px
constexpr double kMapTop = 64;     // px
constexpr double kMapRight = 24;   // px
constexpr double kMapBottom = 56;  // px

using Colour = std::array<double, 3>;

/// Five colours of the colour map cividis, whose order colour-blind readers see, too.
constexpr std::array<Colour, 5> kColours{
    {{0, 34, 78}, {66, 78, 108}, {125, 124, 120}, {187, 175, 113}, {254, 232, 56}}};

/// Returns the position of a value in the map's range, 0..1.
double share_of(const HeatMap& map, double value) {
  const AxisMap axis{map.range, 0, 1, map.scale};
  const double least = map.scale == AxisScale::logarithmic ? map.range.low : value;
  return std::clamp(axis(std::max(value, least)), 0.0, 1.0);
}

Colour colour_at(double share) {
  const double place = share * static_cast<double>(kColours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kColours.size() - 2);
  const double rest = place - static_cast<double>(below);
  Colour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    colour.at(i) = (1 - rest) * kColours.at(below).at(i) + rest * kColours.at(below + 1).at(i);
  }
  return colour;
}

std::string hex(const Colour& colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(colour[0]),
                static_cast<unsigned>(colour[1]), static_cast<unsigned>(colour[2]));
  return text.data();
}

std::string draw_cell(const HeatMap& map, double value, double x, double y) {
  const bool is_known = std::isfinite(value);
  const double share = is_known ? share_of(map, value) : 1;
  const std::string fill = is_known ? hex(colour_at(share)) : "#fff";
  constexpr double kLight = 0.55;
  return vo::concat("<rect x=\"", px(x), "\" y=\"", px(y), "\" width=\"", px(kCell), "\" height=\"",
                    px(kCell), "\" fill=\"", fill, "\"/>\n<text x=\"", px(x + kCell / 2), "\" y=\"",
                    px(y + kCell / 2 + 4), "\" text-anchor=\"middle\" class=\"",
                    share > kLight ? "dark" : "light", "\">", format_decimals(value, map.decimals),
                    "</text>\n");
}

std::string draw_map(const HeatMap& map, double left) {
  const double height = kCell * static_cast<double>(map.y.size());
  const double width = kCell * static_cast<double>(map.x.size());
  std::string svg = text_at(left + width / 2, kMapTop - 12, "middle", map.title);
  for (std::size_t i = 0; i < map.y.size(); ++i) {
    const double y = kMapTop + height - kCell * static_cast<double>(i + 1);
    svg += text_at(left - 8, y + kCell / 2 + 4, "end", tick_label(map.y[i]));
    for (std::size_t j = 0; j < map.x.size(); ++j) {
      svg += draw_cell(map, map.values[i][j], left + kCell * static_cast<double>(j), y);
    }
  }
  for (std::size_t j = 0; j < map.x.size(); ++j) {
    svg += text_at(left + kCell * (static_cast<double>(j) + 0.5), kMapTop + height + 18, "middle",
                   tick_label(map.x[j]));
  }
  const double middle = kMapTop + height / 2;
  return svg + text_at(left + width / 2, kMapTop + height + 40, "middle", map.x_title) +
         vo::concat("<text text-anchor=\"middle\" transform=\"translate(", px(left - 48), " ",
                    px(middle), ") rotate(-90)\">", map.y_title, "</text>\n");
}

}  // namespace

std::string draw_heat_maps(const std::string& title, const std::vector<HeatMap>& maps) {
  std::string cells;
  double left = 0;
  double height = 0;
  for (const HeatMap& map : maps) {
    cells += draw_map(map, left + kMapLeft);
    left += kMapLeft + kCell * static_cast<double>(map.x.size()) + kMapRight;
    height = std::max(height, kMapTop + kCell * static_cast<double>(map.y.size()) + kMapBottom);
  }
  return vo::concat(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", px(left), "\" height=\"", px(height),
      "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<style>text{font:12px sans-serif;fill:#222}.title{font:bold 14px sans-serif}"
      ".light{fill:#fff}.dark{fill:#111}</style>\n",
      "<text class=\"title\" x=\"20\" y=\"24\">", title, "</text>\n", cells, "</svg>\n");
}

}  // namespace tools
