#include "tools/depth/depth_course.h"

#include <utility>

#include "tools/plot/plot.h"

namespace tools {
namespace {

constexpr const char* kTitle = "Inverse-depth map of each frame beside the true depth";

template <typename Value>
PlotSeries series_of(const std::vector<MappedFrame>& frames, const std::string& name, int style,
                     Value value) {
  PlotSeries series{.name = name, .style = style, .mark = PlotMark::line, .points = {}};
  for (const MappedFrame& frame : frames) {
    series.points.push_back(
        {.x = frame.timestamp - frames.front().timestamp, .y = value(frame.errors)});
  }
  return series;
}

}  // namespace

std::string draw_course(const std::vector<MappedFrame>& frames) {
  if (frames.empty()) {
    return draw_plot(kTitle, {});
  }
  const double first = frames.front().errors.scale;
  std::vector<PlotPanel> panels(3);
  panels[0].y = {.title = "change of scale since the first map, %"};
  panels[0].series = {series_of(frames, "confident hypotheses", 0, [first](const MapErrors& e) {
    return 100 * (e.scale / first - 1);
  })};
  panels[1].y = {.title = "median relative error of inverse depth, %"};
  panels[1].series = {series_of(frames, "confident hypotheses", 0,
                                [](const MapErrors& e) { return e.confident.median_percent; })};
  panels[2].y = {.title = "number of hypotheses"};
  panels[2].series = {
      series_of(frames, "confident hypotheses", 0,
                [](const MapErrors& e) { return static_cast<double>(e.confident.count); }),
      series_of(frames, "all of which anything is known", 1,
                [](const MapErrors& e) { return static_cast<double>(e.all.count); })};
  for (PlotPanel& panel : panels) {
    panel.x = {.title = "time, s"};
  }
  return draw_plot(kTitle, panels);
}

}  // namespace tools
