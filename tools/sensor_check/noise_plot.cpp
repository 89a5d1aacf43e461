#include <algorithm>

#include "tools/plot/plot.h"
#include "tools/sensor_check/noise_table.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

constexpr double kMillimetres = 1000;

std::string name_of(synth::SensorPreset preset, const char* what) {
  return std::string(vo::to_string(preset)) + what;
}

/// Adds a preset's line of the formula and marks of the measurements, unless they are empty.
void add_series(synth::SensorPreset preset, std::vector<PlotPoint> formula,
                std::vector<PlotPoint> measured, PlotPanel& panel) {
  if (!formula.empty()) {
    const int style = static_cast<int>(preset);
    panel.series.push_back(
        {name_of(preset, ": formula"), style, PlotMark::line, std::move(formula)});
    panel.series.push_back(
        {name_of(preset, ": measured"), style, PlotMark::points, std::move(measured)});
  }
}

PlotPanel depth_panel(const std::vector<NoiseSample>& samples, double lean_deg) {
  PlotPanel panel;
  panel.x = {.title = "depth, m"};
  panel.y = {.title = "std. deviation of depth, mm, seen at " + vo::format_real(lean_deg) + " deg",
             .scale = AxisScale::logarithmic};
  for (const auto& [preset, name] : enum_names(synth::SensorPreset{})) {
    std::vector<PlotPoint> formula;
    std::vector<PlotPoint> measured;
    for (const NoiseSample& sample : samples) {
      if (sample.preset == preset && sample.lean_deg == lean_deg) {
        formula.push_back({sample.depth, kMillimetres * sample.formula.deviation});
        measured.push_back({sample.depth, kMillimetres * sample.measured.deviation});
      }
    }
    add_series(preset, std::move(formula), std::move(measured), panel);
  }
  return panel;
}

PlotPanel grey_panel(const std::vector<GreyNoise>& samples) {
  PlotPanel panel;
  panel.x = {.title = "linear grey, 1 = saturated", .scale = AxisScale::logarithmic};
  panel.y = {.title = "std. deviation of linear green, 1 = saturated",
             .scale = AxisScale::logarithmic};
  for (const auto& [preset, name] : enum_names(synth::SensorPreset{})) {
    std::vector<PlotPoint> formula;
    std::vector<PlotPoint> measured;
    for (const GreyNoise& sample : samples) {
      if (sample.preset == preset) {
        formula.push_back({sample.grey, sample.formula});
        measured.push_back({sample.grey, sample.measured});
      }
    }
    add_series(preset, std::move(formula), std::move(measured), panel);
  }
  return panel;
}

}  // namespace

std::string plot_noise(const std::vector<NoiseSample>& depth, const std::vector<GreyNoise>& grey) {
  return draw_plot("Sensor presets: noise by formula and as measured",
                   {depth_panel(depth, 0), depth_panel(depth, 70), grey_panel(grey)});
}

}  // namespace tools
