#include "tools/plot/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tools/plot/svg.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr double kPanelWidth = 470;   // px
constexpr double kPanelHeight = 330;  // px
constexpr double kLeft = 66;          // px, from the panel's edge to its axis
constexpr double kRight = 22;         // px
constexpr double kTop = 30;           // px
constexpr double kBottom = 46;        // px
constexpr double kTitleHeight = 30;   // px
constexpr double kLegendRow = 20;     // px
constexpr double kMarker = 4;         // px, half the size of a marker

constexpr const char* kStyle =
    "<style>text{font:12px sans-serif;fill:#222}.title{font:bold 14px sans-serif}"
    ".axis{stroke:#ddd;stroke-width:1}</style>\n";

/// Okabe and Ito's colours, which colour-blind readers can distinguish, also in grey.
constexpr std::array kPalette{"#0072b2", "#d55e00", "#333333", "#009e73",
                              "#cc79a7", "#e69f00", "#56b4e9", "#8a6d00"};

const char* colour(int style) {
  return kPalette.at(static_cast<std::size_t>(style) % kPalette.size());
}

bool is_drawable(const PlotPanel& panel, const PlotPoint& point) {
  const auto fits = [](double value, AxisScale scale) {
    return std::isfinite(value) && (scale == AxisScale::linear || value > 0);
  };
  return fits(point.x, panel.x.scale) && fits(point.y, panel.y.scale);
}

bool has_bars(const PlotPanel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [](const PlotSeries& series) { return series.mark == PlotMark::bar; });
}

/// Returns the range with a margin of about 6 % at each end, but none below a requested lower end.
Range widened(const Range& values, const PlotAxis& axis) {
  constexpr double kRoom = 0.06;
  if (axis.scale == AxisScale::logarithmic) {
    const double factor = std::pow(values.high / values.low, kRoom) * 1.05;
    return {values.low / factor, values.high * factor};
  }
  const double room = values.size() > 0 ? kRoom * values.size() : 1;
  const bool ends_low = axis.include.size() > 0 && axis.include.low == values.low;
  return {ends_low ? values.low : values.low - room, values.high + room};
}

Range shown_range(const PlotPanel& panel, const PlotAxis& axis, double PlotPoint::*value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Range range{kInfinity, -kInfinity};
  for (const PlotSeries& series : panel.series) {
    for (const PlotPoint& point : series.points) {
      if (is_drawable(panel, point)) {
        range.include(point.*value);
      }
    }
  }
  if (axis.include.size() > 0) {
    range.include(axis.include.low);
    range.include(axis.include.high);
  }
  if (!(range.low <= range.high)) {
    range = {1, 2};
  }
  if (!axis.categories.empty()) {
    return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
  }
  return widened(range, axis);
}

struct Frame {
  AxisMap x;
  AxisMap y;
};

Frame panel_frame(const PlotPanel& panel, double left, double top) {
  PlotAxis y_axis = panel.y;
  if (has_bars(panel)) {
    y_axis.include.include(0);
    y_axis.include.high = std::max(y_axis.include.high, 1e-9);
  }
  return {{shown_range(panel, panel.x, &PlotPoint::x), left + kLeft, left + kPanelWidth - kRight,
           panel.x.scale},
          {shown_range(panel, y_axis, &PlotPoint::y), top + kPanelHeight - kBottom, top + kTop,
           panel.y.scale}};
}

std::string marker(int style, double x, double y) {
  const std::string fill = vo::concat("fill=\"", colour(style), "\"");
  const auto polygon = [&](const std::vector<SvgPoint>& corners) {
    std::string text = "<polygon " + fill + " points=\"";
    for (const auto& [dx, dy] : corners) {
      text += px(x + dx * kMarker) + "," + px(y + dy * kMarker) + " ";
    }
    return text + "\"/>\n";
  };
  switch (style % 4) {
    case 0:
      return vo::concat("<circle cx=\"", px(x), "\" cy=\"", px(y), "\" r=\"", px(kMarker), "\" ",
                        fill, "/>\n");
    case 1:
      return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case 2:
      return polygon({{0, -1.2}, {1.1, 0.9}, {-1.1, 0.9}});
    default:
      return polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
  }
}

std::string stroke(const PlotSeries& series) {
  return vo::concat("fill=\"none\" stroke-width=\"2\" stroke=\"", colour(series.style), "\"",
                    series.mark == PlotMark::dashes ? " stroke-dasharray=\"7 4\"" : "");
}

bool has_line(PlotMark mark) {
  return mark == PlotMark::line || mark == PlotMark::dashes || mark == PlotMark::line_and_points;
}

bool has_markers(PlotMark mark) {
  return mark == PlotMark::points || mark == PlotMark::line_and_points;
}

std::string draw_series(const PlotPanel& panel, const PlotSeries& series, const Frame& frame) {
  std::vector<SvgPoint> places;
  std::string text;
  for (const PlotPoint& point : series.points) {
    if (!is_drawable(panel, point)) {
      continue;
    }
    const double x = frame.x(point.x);
    places.push_back({x, frame.y(point.y)});
    if (point.deviation > 0) {
      const double low = std::max(point.y - point.deviation, frame.y.values.low);
      const double high = std::min(point.y + point.deviation, frame.y.values.high);
      text += line(x, frame.y(low), x, frame.y(high),
                   vo::concat("stroke-width=\"1.2\" stroke=\"", colour(series.style), "\""));
    }
  }
  if (has_line(series.mark) && places.size() > 1) {
    text += polyline(places, stroke(series));
  }
  for (const auto& [x, y] : places) {
    text += has_markers(series.mark) ? marker(series.style, x, y) : "";
  }
  return text;
}

/// Returns the bars of one series; all series of the panel share the width of a category.
std::string draw_bars(const PlotPanel& panel, std::size_t index, const Frame& frame) {
  const PlotSeries& series = panel.series[index];
  const double slot = frame.x(1) - frame.x(0);
  const double width = 0.8 * slot / static_cast<double>(panel.series.size());
  std::string text;
  for (const PlotPoint& point : series.points) {
    if (!is_drawable(panel, point)) {
      continue;
    }
    const double left = frame.x(point.x) - 0.4 * slot + static_cast<double>(index) * width;
    const double top = frame.y(point.y);
    text += vo::concat("<rect x=\"", px(left), "\" y=\"", px(top), "\" width=\"", px(0.92 * width),
                       "\" height=\"", px(frame.y(0) - top), "\" fill=\"", colour(series.style),
                       "\"/>\n");
  }
  return text;
}

std::string draw_categories(const PlotAxis& axis, const Frame& frame) {
  std::string text;
  for (std::size_t i = 0; i < axis.categories.size(); ++i) {
    text += text_at(frame.x(static_cast<double>(i)), frame.y.first_px + 16, "middle",
                    axis.categories[i]);
  }
  return text + text_at((frame.x.first_px + frame.x.last_px) / 2, frame.y.first_px + 34, "middle",
                        axis.title);
}

std::string draw_panel(const PlotPanel& panel, double left, double top) {
  const Frame frame = panel_frame(panel, left, top);
  std::string text = panel.x.categories.empty() ? draw_x_axis(frame.x, frame.y, panel.x.title)
                                                : draw_categories(panel.x, frame);
  text += draw_y_axis(frame.x, frame.y, panel.y.title);
  text += line(frame.x.first_px, frame.y.first_px, frame.x.last_px, frame.y.first_px,
               "stroke=\"#666\"");
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    text += panel.series[i].mark == PlotMark::bar ? draw_bars(panel, i, frame)
                                                  : draw_series(panel, panel.series[i], frame);
  }
  return text;
}

std::vector<PlotSeries> legend_entries(const std::vector<PlotPanel>& panels) {
  std::vector<PlotSeries> entries;
  for (const PlotPanel& panel : panels) {
    for (const PlotSeries& series : panel.series) {
      const bool known = std::any_of(entries.begin(), entries.end(), [&](const PlotSeries& entry) {
        return entry.name == series.name;
      });
      if (!known) {
        entries.push_back(series);
      }
    }
  }
  return entries;
}

std::string draw_sample(const PlotSeries& entry, double x, double y) {
  if (entry.mark == PlotMark::bar) {
    return vo::concat("<rect x=\"", px(x), "\" y=\"", px(y - 6), "\" width=\"24\" height=\"11\" ",
                      "fill=\"", colour(entry.style), "\"/>\n");
  }
  return (has_line(entry.mark) ? line(x, y, x + 26, y, stroke(entry)) : "") +
         (has_markers(entry.mark) ? marker(entry.style, x + 13, y) : "");
}

struct Legend {
  std::string svg;
  double height = 0;  ///< px
};

Legend draw_legend(const std::vector<PlotSeries>& entries, double width) {
  constexpr double kCharacter = 6.6;  // px, generous mean width of a character
  Legend legend;
  double x = 20;
  double y = kTitleHeight + kLegendRow / 2;
  for (const PlotSeries& entry : entries) {
    const double entry_width = 52 + kCharacter * static_cast<double>(entry.name.size());
    if (x + entry_width > width && x > 20) {
      x = 20;
      y += kLegendRow;
    }
    legend.svg += draw_sample(entry, x, y) + text_at(x + 32, y + 4, "start", entry.name);
    x += entry_width;
  }
  legend.height = y - kTitleHeight + kLegendRow / 2;
  return legend;
}

}  // namespace

std::string draw_plot(const std::string& title, const std::vector<PlotPanel>& panels) {
  const double width = kPanelWidth * static_cast<double>(panels.size());
  const Legend legend = draw_legend(legend_entries(panels), width);
  const double top = kTitleHeight + legend.height;
  std::string svg =
      vo::concat("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", px(width), "\" height=\"",
                 px(top + kPanelHeight),
                 "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n", kStyle);
  svg += vo::concat("<text class=\"title\" x=\"20\" y=\"20\">", title, "</text>\n") + legend.svg;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    svg += draw_panel(panels[i], kPanelWidth * static_cast<double>(i), top);
  }
  return svg + "</svg>\n";
}

}  // namespace tools
