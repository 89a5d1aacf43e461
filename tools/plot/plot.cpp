#include "tools/plot/plot.h"

#include <algorithm>

#include "tools/plot/plot_mark.h"
#include "tools/plot/plot_panel.h"
#include "tools/plot/svg.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr double kSide = 20;  // px, from the drawing's sides to title and legend

/// Part of a drawing; the parts are below each other.
struct Block {
  std::string svg;
  double width = 0;   ///< px
  double height = 0;  ///< px
};

std::string moved_to(const SvgPoint& place, const std::string& svg) {
  return vo::concat("<g transform=\"translate(", px(place[0]), " ", px(place[1]), ")\">\n", svg,
                    "</g>\n");
}

Block draw_panels(const std::vector<PlotPanel>& panels, PlotLayout layout) {
  std::vector<DrawnPanel> drawn(panels.size());
  std::transform(panels.begin(), panels.end(), drawn.begin(), draw_panel);
  const bool is_stacked = layout == PlotLayout::stacked;
  double left = 0;
  for (const DrawnPanel& panel : drawn) {
    left = is_stacked ? std::max(left, panel.left) : 0;
  }
  Block all;
  for (const DrawnPanel& panel : drawn) {
    const SvgPoint place{is_stacked ? left : all.width + panel.left,
                         is_stacked ? all.height + panel.above : panel.above};
    all.svg += moved_to(place, panel.svg);
    all.width = std::max(all.width, place[0] + panel.right);
    all.height = std::max(all.height, place[1] + panel.below);
  }
  return all;
}

/// Returns the legend of all panels in rows as wide as these, or as the widest entry.
Block draw_legend(const std::vector<PlotPanel>& panels, double width) {
  constexpr double kRow = 20;     // px
  constexpr double kSample = 32;  // px, from the sample's left end to the name
  Block legend{"", width, 0};
  std::vector<std::string> names{""};
  double x = width;
  for (const PlotPanel& panel : panels) {
    for (const PlotSeries& series : panel.series) {
      if (std::find(names.begin(), names.end(), series.name) != names.end()) {
        continue;
      }
      names.push_back(series.name);
      const double entry = kSample + text_width(series.name) + kSide;
      if (legend.height == 0 || x + entry > width) {
        x = kSide;
        legend.height += kRow;
      }
      const double y = legend.height - kRow / 2;
      legend.svg += draw_sample(series, x, y) + text_at(x + kSample, y + 4, "start", series.name);
      x += entry;
      legend.width = std::max(legend.width, x);
    }
  }
  return legend;
}

}  // namespace

std::string draw_plot(const std::string& title, const std::vector<PlotPanel>& panels,
                      PlotLayout layout) {
  constexpr double kTitleText = 16;  // px, of a plain text as wide as the title's bold 14 px
  const Block heading{text_at(kSide, 20, "start", title, "class=\"title\""),
                      2 * kSide + text_width(title, kTitleText), 30};
  const Block axes = draw_panels(panels, layout);
  std::string svg;
  double width = 0;
  double height = 0;
  for (const Block& block : {heading, draw_legend(panels, axes.width), axes}) {
    svg += moved_to({0, height}, block.svg);
    width = std::max(width, block.width);
    height += block.height;
  }
  return vo::concat(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"", px(width),
      "\" height=\"", px(height), "\" viewBox=\"0 0 ", px(width), " ", px(height),
      "\">\n<style>.plot{font:12px sans-serif;fill:#222}.plot .title{font:bold 14px sans-serif}"
      ".plot .grid{stroke:#ddd}.plot .foot{stroke:#666}.plot rect{shape-rendering:crispEdges}"
      "</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      svg, "</svg>\n");
}

}  // namespace tools
