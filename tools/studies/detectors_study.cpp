#include "tools/plot/plot.h"
#include "tools/scenario/error_titles.h"
#include "tools/studies/study.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// Returns the detectors that the study compares.
std::vector<Variant> detectors() {
  return {
      {"Canny, Otsu", {{"edges.threshold", "otsu"}}},
      {"Canny, percentile", {{"edges.threshold", "percentile"}}},
      {"Canny, fixed", {{"edges.threshold", "fixed"}}},
  };
}

std::vector<Variant> references() {
  return {
      {"frame to frame", {{"keyframes.every", "1"}}},
      {"keyframe every 4", {{"keyframes.every", "4"}}},
  };
}

Assignments joined(Assignments first, const Assignments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

PlotPanel detectors_make_panel(const std::string& title) {
  PlotPanel panel{.y = {.title = title}};
  for (const Variant& detector : detectors()) {
    panel.x.categories.push_back(detector.name);
  }
  for (const Variant& reference : references()) {
    panel.series.push_back(
        {reference.name, static_cast<int>(panel.series.size()), PlotMark::bar, {}});
  }
  return panel;
}

/// Returns a sentence on the smallest value of a column and its row.
std::string best(const Table& table, std::size_t column, const char* what, const char* unit) {
  std::size_t best_row = 0;
  const auto value = [&](std::size_t row) { return std::get<double>(table.rows[row][column]); };
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    best_row = value(row) < value(best_row) ? row : best_row;
  }
  const auto text = [&](std::size_t i) { return std::get<std::string>(table.rows[best_row][i]); };
  return vo::concat("Least ", what, ": ", format_decimals(value(best_row), 2), " ", unit, ", ",
                    text(0), ", ", text(1), ".");
}

}  // namespace

StudyReport study_detectors(const Clip& clip, const StudySettings& settings,
                            const vo::Progress& progress) {
  Table table{.columns = {{"detector"},
                          {"reference"},
                          {"points"},
                          {"rpe_mm", 2},
                          {"rpe_deg", 3},
                          {"ate_mm", 2},
                          {"tracked_percent", 1},
                          {"ms_per_frame", 1}}};
  PlotPanel rpe = detectors_make_panel("RPE, mm/s");
  PlotPanel ate = detectors_make_panel(ate_title("mm", vo::TrajectoryAlignment::se3));
  const std::vector<Variant> rows = detectors();
  const std::vector<Variant> modes = references();
  for (std::size_t d = 0; d < rows.size(); ++d) {
    for (std::size_t m = 0; m < modes.size(); ++m) {
      const ClipScore result =
          score(clip, settings.options({}, joined(rows[d].changes, modes[m].changes)));
      table.add_row({rows[d].name, modes[m].name, result.points, result.rpe_mm, result.rpe_deg,
                     result.ate_mm, result.tracked_percent, result.ms_per_frame});
      rpe.series[m].points.push_back({static_cast<double>(d), result.rpe_mm});
      ate.series[m].points.push_back({static_cast<double>(d), result.ate_mm});
      progress(table.rows.size(), rows.size() * modes.size());
    }
  }
  constexpr std::size_t kRpe = 3;
  constexpr std::size_t kAte = 5;
  return {.name = "detectors",
          .title = "Edge detectors, frame to frame and with keyframes: " + clip.name,
          .method = vo::concat(
              clip.frames.size(), " frames, ", settings.described(),
              ". RPE is the RMSE over one second, time the median processor time per frame."),
          .table = table,
          .findings = {best(table, kRpe, "RPE", "mm/s"), best(table, kAte, "ATE", "mm")},
          .plot = draw_plot("Edge detectors: " + clip.name, {rpe, ate}),
          .more = {}};
}

}  // namespace tools
