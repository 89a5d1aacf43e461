#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tools/depth/depth_errors.h"
#include "tools/depth/mono_run.h"
#include "tools/plot/plot.h"
#include "tools/studies/study.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/evaluation/evaluate.h"
#include "vo/sequence_odometry/track_mono.h"

namespace tools {
namespace {

/// Returns variants that each change one option of the default.
std::vector<Variant> mono_variants() {
  return {{"default", {}},
          {"propagate every frame", {{"depth_map.propagate", "always"}}},
          {"keyframe every 5", {{"depth_map.host.every", "5"}}},
          {"keyframe every 10", {{"depth_map.host.every", "10"}}},
          {"keyframe every 20", {{"depth_map.host.every", "20"}}},
          {"no regularisation", {{"depth_map.regularise", "none"}}},
          {"Gaussian-Beta fusion", {{"depth_map.fusion", "gaussian_beta"}}},
          {"unknown depth", {{"bootstrap", "auto"}}},
          {"flat start", {{"bootstrap", "flat"}}},
          {"random start", {{"bootstrap", "random"}}}};
}

/// Scores of one variant; NaN where too little was tracked to measure.
struct MonoScore {
  double ate_percent = kUnknown;  ///< % of path length; Sim(3) unless metric
  double scale_error_percent = kUnknown;
  double tracked_percent = 0;
  double mapping_ms = kUnknown;
  std::optional<MapErrors> errors;  ///< errors of the last map
};

vo::MonoImages images_of(const Clip& clip, std::size_t& next) {
  return {.camera = clip.camera,
          .T_world_first = {},
          .size = clip.frames.size(),
          .next = [&]() -> std::optional<vo::RgbdFrame> {
            if (next >= clip.frames.size()) {
              return std::nullopt;
            }
            vo::RgbdFrame frame = clip.frames[next];
            if (next++ > 0) {
              frame.depth = vo::DepthImage();
            }
            return frame;
          }};
}

std::optional<MapErrors> judged(const Clip& clip, const vo::MonoOdometry& odometry, bool metric) {
  const double host_time = odometry.map().empty() ? -1 : odometry.map().host().timestamp;
  const auto host =
      std::find_if(clip.frames.begin(), clip.frames.end(),
                   [&](const vo::RgbdFrame& frame) { return frame.timestamp == host_time; });
  if (host == clip.frames.end() || host->depth.empty()) {
    return std::nullopt;
  }
  return map_errors(odometry.map(), {.depth = host->depth, .causes = {}}, {}, metric ? 1 : 0);
}

void judge_trajectory(const Clip& clip, const vo::Trajectory& estimate, bool metric,
                      MonoScore& score) {
  constexpr std::size_t kMinPoses = 3;
  const double length = vo::path_length(clip.truth);
  if (estimate.size() < kMinPoses || length == 0) {
    return;
  }
  const vo::TrajectoryErrors scaled =
      vo::evaluate(clip.truth, estimate, {.alignment = vo::TrajectoryAlignment::sim3});
  const vo::TrajectoryErrors rigid = vo::evaluate(clip.truth, estimate);
  score.ate_percent = 100 * (metric ? rigid : scaled).ate.rmse / length;
  score.scale_error_percent = metric ? 100 * std::abs(1 / scaled.scale - 1) : kUnknown;
}

MonoScore mono_measure(const Clip& clip, const vo::MonoOptions& options) {
  const bool metric = is_metric(options.bootstrap);
  std::size_t next = 0;
  MonoScore score;
  const vo::MonoSequenceResult result = vo::track_mono_images(
      images_of(clip, next), options,
      [&](const vo::RgbdFrame&, const vo::MonoOdometry& odometry, const vo::MonoResult& frame) {
        if (next == clip.frames.size() && vo::is_in_map(frame.state)) {
          score.errors = judged(clip, odometry, metric);
        }
      },
      [](std::size_t, std::size_t) {});
  judge_trajectory(clip, result.trajectory, metric, score);
  score.tracked_percent = 100 * result.tracking().tracked_fraction();
  std::vector<double> times;
  for (const vo::StageTimes& time : result.times) {
    times.push_back(time.mapping_ms);
  }
  score.mapping_ms = vo::percentile(times, 0.5);
  return score;
}

std::vector<TableCell> cells(const std::string& name, const MonoScore& score) {
  const DepthErrors nothing{0, kUnknown, kUnknown, kUnknown, kUnknown};
  const DepthErrors& depth = score.errors ? score.errors->confident : nothing;
  return {name,
          score.ate_percent,
          score.scale_error_percent,
          depth.median_percent,
          depth.p90_percent,
          depth.outliers_percent,
          depth.nees,
          score.errors ? score.errors->density_percent : kUnknown,
          score.tracked_percent,
          score.mapping_ms};
}

PlotPanel mono_make_panel(const Table& table, std::size_t column, const std::string& title) {
  PlotPanel panel{.y = {.title = title}};
  panel.series = {{"numbers are rows of the table", 0, PlotMark::bar, {}}};
  for (const std::vector<TableCell>& row : table.rows) {
    panel.x.categories.push_back(std::to_string(panel.x.categories.size() + 1));
    panel.series[0].points.push_back(
        {static_cast<double>(panel.series[0].points.size()), std::get<double>(row[column])});
  }
  return panel;
}

}  // namespace

StudyReport study_mono(const Clip& clip, const StudySettings& settings,
                       const vo::Progress& progress) {
  Table table{.columns = {{"variant"},
                          {"ate_percent", 3},
                          {"scale_error_percent", 2},
                          {"depth_median_percent", 2},
                          {"depth_p90_percent", 2},
                          {"outliers_percent", 1},
                          {"nees", 2},
                          {"density_percent", 0},
                          {"tracked_percent", 1},
                          {"mapping_ms", 2}}};
  const std::vector<Variant> rows = mono_variants();
  for (const Variant& variant : rows) {
    table.add_row(cells(variant.name, mono_measure(clip, settings.mono_options(variant.changes))));
    progress(table.rows.size(), rows.size());
  }
  return {.name = "mono",
          .title = "Monocular odometry, one change at a time: " + clip.name,
          .method = vo::concat(
              clip.frames.size(),
              " frames; colour alone but for the first depth image, which \"unknown depth\", "
              "\"flat start\" and \"random start\" do without: their ATE is Sim(3)-aligned. Errors "
              "of depth are relative, of the inverse depths of the last map's confident "
              "hypotheses; outliers err by more than 10 %, density is the confident share of all "
              "edge pixels, mapping the median per frame. Bars are in the order of the table."),
          .table = table,
          .findings = {},
          .plot = draw_plot(
              "Monocular odometry: " + clip.name,
              {mono_make_panel(table, 1, "ATE, % of the path, SE(3); Sim(3) where scale is free"),
               mono_make_panel(table, 3, "median relative error of inverse depth, %"),
               mono_make_panel(table, 5, "inverse depths more than 10 % off, %")}),
          .more = {}};
}

}  // namespace tools
