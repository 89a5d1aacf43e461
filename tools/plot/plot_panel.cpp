#include "tools/plot/plot_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tools/plot/plot_mark.h"
#include "tools/plot/svg.h"

namespace tools {
namespace {

constexpr double kMargin = 10;       // px, between texts and the ends of the panel
constexpr double kLabelGap = 6;      // px, between labels, and from them to the axis
constexpr double kRowDistance = 36;  // px, between ticks above each other, about

/// Returns the range with a margin of about 6 % at each end, but none below 0.
Range widened(const Range& values, AxisScale scale) {
  constexpr double kRoom = 0.06;
  if (scale == AxisScale::logarithmic) {
    const double factor = std::pow(values.high / values.low, kRoom) * 1.05;
    return {values.low / factor, values.high * factor};
  }
  const double room = values.size() > 0 ? kRoom * values.size() : 1;
  return {values.low == 0 ? 0 : values.low - room, values.high + room};
}

Range shown_range(const PlotPanel& panel, const PlotAxis& axis, double PlotPoint::*value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!axis.categories.empty()) {
    return {-0.5, static_cast<double>(axis.categories.size()) - 0.5};
  }
  Range range{kInfinity, -kInfinity};
  for (const PlotSeries& series : panel.series) {
    for (const PlotPoint& point : series.points) {
      if (is_drawable(panel, point)) {
        range.include(point.*value);
      }
    }
    if (series.mark == PlotMark::bar && value == &PlotPoint::y && axis.scale == AxisScale::linear) {
      range.include(0);
    }
  }
  if (axis.include.size() > 0) {
    range.include(axis.include.low);
    range.include(axis.include.high);
  }
  return range.low <= range.high ? widened(range, axis.scale) : Range{1, 2};
}

PlotFrame frame_of(const PlotPanel& panel) {
  PlotFrame frame{{shown_range(panel, panel.x, &PlotPoint::x), 0, panel.width, panel.x.scale},
                  {shown_range(panel, panel.y, &PlotPoint::y), panel.height, 0, panel.y.scale}};
  if (panel.has_equal_scales) {
    Range& x = frame.x.values;
    Range& y = frame.y.values;
    const double per_px = std::max(x.size() / panel.width, y.size() / panel.height);
    const double more_x = per_px * panel.width - x.size();
    const double more_y = per_px * panel.height - y.size();
    x = {x.low - more_x / 2, x.high + more_x / 2};
    y = {y.low - more_y / 2, y.high + more_y / 2};
  }
  return frame;
}

/// A label beside an axis.
struct AxisLabel {
  double value = 0;
  std::string text;
};

/// Returns the categories of an axis, or else ticks that are about `distance_px` apart.
std::vector<AxisLabel> labels_of(const std::vector<std::string>& categories, const AxisMap& map,
                                 double distance_px) {
  std::vector<AxisLabel> labels;
  for (const std::string& category : categories) {
    labels.push_back({static_cast<double>(labels.size()), category});
  }
  if (categories.empty()) {
    const double length = std::abs(map.last_px - map.first_px);
    for (const double value : axis_ticks(map, static_cast<int>(length / distance_px))) {
      labels.push_back({value, tick_label(value)});
    }
  }
  return labels;
}

double greatest_width(const std::vector<AxisLabel>& labels) {
  double width = 0;
  for (const AxisLabel& label : labels) {
    width = std::max(width, text_width(label.text));
  }
  return width;
}

/// Returns whether labels below an axis have gaps between them.
bool are_apart(const std::vector<AxisLabel>& labels, const AxisMap& map) {
  for (std::size_t i = 1; i < labels.size(); ++i) {
    const double widths = text_width(labels[i - 1].text) + text_width(labels[i].text);
    if (map(labels[i].value) - map(labels[i - 1].value) < widths / 2 + kLabelGap) {
      return false;
    }
  }
  return true;
}

/// Draws the labels below the area, fewer ticks or turned categories where they would overlap.
void draw_x_axis(const PlotAxis& axis, const PlotFrame& frame, DrawnPanel& drawn) {
  constexpr double kTurnDeg = 35;
  constexpr double kTurn = kTurnDeg * std::numbers::pi / 180;
  const double bottom = frame.y.first_px;
  double distance = 47;  // px
  std::vector<AxisLabel> labels = labels_of(axis.categories, frame.x, distance);
  for (; !are_apart(labels, frame.x) && distance < frame.x.last_px / 3; distance *= 1.2) {
    labels = labels_of(axis.categories, frame.x, distance);
  }
  const bool is_turned = !are_apart(labels, frame.x);
  for (const AxisLabel& label : labels) {
    const double x = frame.x(label.value);
    drawn.svg += axis.categories.empty() ? line(x, bottom, x, 0, "class=\"grid\"") : "";
    drawn.svg += is_turned ? text_at(x + 4, bottom + 14, "end", label.text, "", kTurnDeg)
                           : text_at(x, bottom + 16, "middle", label.text);
    if (is_turned) {
      drawn.left = std::max(drawn.left, std::cos(kTurn) * text_width(label.text) - x + kMargin);
    }
  }
  const double title_at = bottom + 36 + (is_turned ? std::sin(kTurn) * greatest_width(labels) : 0);
  drawn.svg += text_at(frame.x.last_px / 2, title_at, "middle", axis.title);
  drawn.below = title_at + (axis.title.empty() ? -kMargin : kMargin);
}

void draw_y_axis(const PlotAxis& axis, const PlotFrame& frame, DrawnPanel& drawn) {
  const std::vector<AxisLabel> labels = labels_of(axis.categories, frame.y, kRowDistance);
  for (const AxisLabel& label : labels) {
    const double y = frame.y(label.value);
    drawn.svg += axis.categories.empty() ? line(0, y, frame.x.last_px, y, "class=\"grid\"") : "";
    drawn.svg += text_at(-kLabelGap, y + 4, "end", label.text);
  }
  drawn.left = std::max(drawn.left, greatest_width(labels) + kLabelGap + kMargin);
  drawn.svg += text_at(0, -10, "start", axis.title);
}

void draw_colour_bar(const PlotColours& colours, double height, DrawnPanel& drawn) {
  constexpr int kSteps = 64;
  constexpr double kWidth = 14;  // px
  const double left = drawn.right + 16;
  for (int i = 0; i < kSteps; ++i) {
    drawn.svg += rectangle(left, height * (kSteps - i - 1) / kSteps, kWidth, height / kSteps,
                           map_colour((i + 0.5) / kSteps));
  }
  const AxisMap map{colours.range, height, 0, colours.scale};
  const std::vector<AxisLabel> labels = labels_of({}, map, kRowDistance);
  for (const AxisLabel& label : labels) {
    drawn.svg += text_at(left + kWidth + kLabelGap, map(label.value) + 4, "start", label.text);
  }
  drawn.right = left + kWidth + kLabelGap + greatest_width(labels) + 3 * kLabelGap;
  drawn.svg += text_at(drawn.right, height / 2, "middle", colours.title, "", 90);
}

}  // namespace

DrawnPanel draw_panel(PlotPanel panel) {
  const double column = panel.cells.values.empty() ? 22 : 52;  // px, for turned labels or numbers
  constexpr double kRow = 18;                                  // px
  panel.width = std::max({panel.width, column * static_cast<double>(panel.x.categories.size()),
                          text_width(panel.x.title), text_width(panel.y.title)});
  panel.height = std::max({panel.height, kRow * static_cast<double>(panel.y.categories.size()),
                           panel.colours ? text_width(panel.colours->title) : 0});
  const PlotFrame frame = frame_of(panel);
  DrawnPanel drawn{.svg = "", .right = panel.width};
  draw_x_axis(panel.x, frame, drawn);
  draw_y_axis(panel.y, frame, drawn);
  drawn.svg +=
      line(0, panel.height, panel.width, panel.height, "class=\"foot\"") + draw_marks(panel, frame);
  if (panel.colours) {
    draw_colour_bar(*panel.colours, panel.height, drawn);
  }
  drawn.right += 22;
  return drawn;
}

}  // namespace tools
