#include "tools/plot/plot_mark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tools/plot/svg.h"
#include "tools/plot/table.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Okabe and Ito's colours, which colour-blind readers can distinguish, also in grey.
constexpr std::array kPalette{"#0072b2", "#d55e00", "#333333", "#009e73",
                              "#cc79a7", "#e69f00", "#56b4e9", "#8a6d00"};

const char* colour(const PlotSeries& series) {
  return kPalette.at(static_cast<std::size_t>(series.style) % kPalette.size());
}

double colour_share(const PlotColours& colours, double value) {
  const AxisMap map{colours.range, 0, 1, colours.scale};
  return map(std::clamp(value, colours.range.low, colours.range.high));
}

std::string draw_markers(const PlotSeries& series, const std::vector<SvgPoint>& places) {
  static const std::array<std::vector<SvgPoint>, 3> kShapes{
      {{{-3.6, -3.6}, {3.6, -3.6}, {3.6, 3.6}, {-3.6, 3.6}},
       {{0, -4.8}, {4.4, 3.6}, {-4.4, 3.6}},
       {{0, -5.2}, {5.2, 0}, {0, 5.2}, {-5.2, 0}}}};
  std::string text;
  if (series.mark != PlotMark::points && series.mark != PlotMark::line_and_points) {
    return text;
  }
  const std::string fill = vo::concat("fill=\"", colour(series), "\"");
  const auto shape = static_cast<std::size_t>(series.style) % (kShapes.size() + 1);
  for (const auto& [x, y] : places) {
    if (shape == 0) {
      text += vo::concat("<circle cx=\"", px(x), "\" cy=\"", px(y), "\" r=\"4\" ", fill, "/>\n");
      continue;
    }
    std::vector<SvgPoint> corners = kShapes.at(shape - 1);
    for (SvgPoint& corner : corners) {
      corner = {x + corner[0], y + corner[1]};
    }
    text += polyline(corners, fill);
  }
  return text;
}

/// Returns the line of a series through places; the shares are those of a coloured line.
std::string draw_line(const PlotSeries& series, const std::vector<SvgPoint>& places,
                      const std::vector<double>& shares) {
  std::string text;
  if (series.mark == PlotMark::coloured_line) {
    for (std::size_t i = 1; i < places.size(); ++i) {
      text += line(places[i - 1][0], places[i - 1][1], places[i][0], places[i][1],
                   vo::concat("stroke=\"", map_colour(shares[i]),
                              "\" stroke-width=\"3\" stroke-linecap=\"round\""));
    }
  } else if (series.mark != PlotMark::points && places.size() > 1) {
    const char* style = series.mark == PlotMark::broad_line ? "6\" stroke-opacity=\"0.25"
                        : series.mark == PlotMark::dashes   ? "2\" stroke-dasharray=\"7 4"
                                                            : "2";
    text = polyline(places, vo::concat("fill=\"none\" stroke-linejoin=\"round\" stroke=\"",
                                       colour(series), "\" stroke-width=\"", style, "\""));
  }
  return text;
}

std::string draw_series(const PlotPanel& panel, const PlotSeries& series, const PlotFrame& frame) {
  std::vector<SvgPoint> places;
  std::vector<double> shares;
  std::string bars;
  const auto inside = [&](double y) {
    return frame.y(std::clamp(y, frame.y.values.low, frame.y.values.high));
  };
  for (const PlotPoint& point : series.points) {
    if (is_drawable(panel, point)) {
      const double x = frame.x(point.x);
      places.push_back({x, frame.y(point.y)});
      shares.push_back(panel.colours ? colour_share(*panel.colours, point.value) : 0);
      if (point.deviation > 0) {
        bars += line(x, inside(point.y - point.deviation), x, inside(point.y + point.deviation),
                     vo::concat("stroke-width=\"1.2\" stroke=\"", colour(series), "\""));
      }
    }
  }
  return bars + draw_line(series, places, shares) + draw_markers(series, places);
}

/// Returns the bars of one series; all series of the panel share the width of a category.
std::string draw_bars(const PlotPanel& panel, std::size_t index, const PlotFrame& frame) {
  const PlotSeries& series = panel.series[index];
  const double slot = frame.x(1) - frame.x(0);
  const double width = 0.8 * slot / static_cast<double>(panel.series.size());
  const double foot = frame.y(std::max(0.0, frame.y.values.low));
  std::string text;
  for (const PlotPoint& point : series.points) {
    if (is_drawable(panel, point)) {
      const double left = frame.x(point.x) - 0.4 * slot + static_cast<double>(index) * width;
      const double end = frame.y(point.y);
      text +=
          rectangle(left, std::min(foot, end), 0.92 * width, std::abs(foot - end), colour(series));
    }
  }
  return text;
}

std::string draw_cells(const PlotPanel& panel, const PlotFrame& frame) {
  constexpr double kLight = 0.65;  // share from which black text is better legible than white
  const double width = frame.x(1) - frame.x(0);
  const double height = frame.y(0) - frame.y(1);
  std::string text;
  for (std::size_t i = 0; i < panel.cells.values.size(); ++i) {
    for (std::size_t j = 0; j < panel.cells.values[i].size(); ++j) {
      const double value = panel.cells.values[i][j];
      if (std::isfinite(value)) {
        const double x = frame.x(static_cast<double>(j));
        const double y = frame.y(static_cast<double>(i));
        const double share = colour_share(panel.colours.value(), value);
        text += rectangle(x - width / 2, y - height / 2, width, height, map_colour(share)) +
                text_at(x, y + 4, "middle", format_decimals(value, panel.cells.decimals),
                        share < kLight ? "fill=\"#fff\"" : "");
      }
    }
  }
  return text;
}

}  // namespace

bool is_drawable(const PlotPanel& panel, const PlotPoint& point) {
  const auto fits = [](double value, AxisScale scale) {
    return std::isfinite(value) && (scale == AxisScale::linear || value > 0);
  };
  return fits(point.x, panel.x.scale) && fits(point.y, panel.y.scale);
}

std::string draw_marks(const PlotPanel& panel, const PlotFrame& frame) {
  std::string text = draw_cells(panel, frame);
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    text += panel.series[i].mark == PlotMark::bar ? draw_bars(panel, i, frame)
                                                  : draw_series(panel, panel.series[i], frame);
  }
  return text;
}

std::string draw_sample(const PlotSeries& series, double x, double y) {
  if (series.mark == PlotMark::bar) {
    return rectangle(x, y - 6, 26, 11, colour(series));
  }
  return draw_line(series, {{x, y}, {x + 9, y}, {x + 17, y}, {x + 26, y}}, {0, 0.2, 0.5, 0.8}) +
         draw_markers(series, {{x + 13, y}});
}

std::string map_colour(double share) {
  // The colour map plasma but for its lightest fifth, which is too light for lines on white.
  constexpr std::array<std::array<double, 3>, 5> kPlasma{
      {{13, 8, 135}, {106, 0, 168}, {177, 42, 144}, {225, 100, 98}, {252, 166, 54}}};
  if (!std::isfinite(share)) {
    return "#999999";
  }
  const double place = share * static_cast<double>(kPlasma.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kPlasma.size() - 2);
  std::array<char, 8> text{"#"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double value = std::lerp(kPlasma.at(below).at(i), kPlasma.at(below + 1).at(i),
                                   place - static_cast<double>(below));
    std::snprintf(&text.at(1 + 2 * i), 3, "%02x", static_cast<unsigned>(value));
  }
  return text.data();
}

}  // namespace tools
