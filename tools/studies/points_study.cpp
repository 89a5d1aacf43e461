#include <array>
#include <cmath>

#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/scenario/error_titles.h"
#include "tools/studies/study.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::array kPointPercents{5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};

/// Returns the fixed options: keyframes and no constant-motion model, as in the paper.
Assignments held() {
  return {{"keyframes.every", "4"}, {"motion_model", "stationary"}};
}

/// Scores of one selection at one share, one per seed.
struct PointsSample {
  std::string selection;
  int percent = 100;
  std::vector<ClipScore> scores;

  Spread spread_of(double ClipScore::*value) const {
    std::vector<double> values;
    for (const ClipScore& score : scores) {
      values.push_back(score.*value);
    }
    return spread(values);
  }
};

/// Returns the number of seeds to run: one if the selection is not random.
int seeds_of(const PointsSample& sample, int seeds) {
  return sample.percent == 100 && sample.selection != "random" ? 1 : seeds;
}

std::vector<PointsSample> planned_samples() {
  std::vector<PointsSample> samples;
  for (const int percent : kPointPercents) {
    samples.push_back({"edges", percent, {}});
    samples.push_back({"random", percent, {}});
  }
  samples.push_back({"all", 100, {}});
  return samples;
}

std::vector<PointsSample> points_measure(const Clip& clip, const StudySettings& settings,
                                         const vo::Progress& progress) {
  std::vector<PointsSample> samples = planned_samples();
  std::size_t total = 0;
  for (const PointsSample& sample : samples) {
    total += static_cast<std::size_t>(seeds_of(sample, settings.seeds));
  }
  std::size_t done = 0;
  for (PointsSample& sample : samples) {
    for (int seed = 1; seed <= seeds_of(sample, settings.seeds); ++seed) {
      const vo::TrackerOptions options =
          settings.options(held(), {{"points.selection", sample.selection},
                                    {"points.fraction", vo::concat(sample.percent / 100.0)},
                                    {"points.seed", vo::concat(seed)}});
      sample.scores.push_back(score(clip, options));
      progress(++done, total);
    }
  }
  return samples;
}

Table points_make_table(const std::vector<PointsSample>& samples) {
  Table table{.columns = {{"selection"},
                          {"percent"},
                          {"points"},
                          {"rpe_mm", 2},
                          {"rpe_sd_mm", 2},
                          {"rpe_deg", 3},
                          {"rpe_sd_deg", 3},
                          {"ate_mm", 2},
                          {"ate_sd_mm", 2},
                          {"tracked_percent", 1},
                          {"ms_per_frame", 1}}};
  for (const PointsSample& sample : samples) {
    const Spread rpe = sample.spread_of(&ClipScore::rpe_mm);
    const Spread rpe_deg = sample.spread_of(&ClipScore::rpe_deg);
    const Spread ate = sample.spread_of(&ClipScore::ate_mm);
    table.add_row({sample.selection, 1.0 * sample.percent,
                   sample.spread_of(&ClipScore::points).mean, rpe.mean, rpe.deviation, rpe_deg.mean,
                   rpe_deg.deviation, ate.mean, ate.deviation,
                   sample.spread_of(&ClipScore::tracked_percent).mean,
                   sample.spread_of(&ClipScore::ms_per_frame).mean});
  }
  return table;
}

PlotPanel points_make_panel(const std::vector<PointsSample>& samples, double ClipScore::*value,
                            const std::string& title) {
  PlotPanel panel{
      .x = {.title = "share of the edge pixels, or of as many random ones, %", .include = {0, 100}},
      .y = {.title = title, .include = {0, 1e-9}}};
  panel.series = {{"edges", 0, PlotMark::line_and_points, {}},
                  {"random pixels, as many", 1, PlotMark::line_and_points, {}},
                  {"all pixels", 2, PlotMark::dashes, {}}};
  for (const PointsSample& sample : samples) {
    const Spread values = sample.spread_of(value);
    if (sample.selection == "all") {
      panel.series[2].points = {{0, values.mean}, {100, values.mean}};
    } else {
      panel.series[sample.selection == "edges" ? 0 : 1].points.push_back(
          {1.0 * sample.percent, values.mean, values.deviation});
    }
  }
  return panel;
}

std::string compared(const char* what, const char* unit, double edges, double random, double all) {
  const double percent = 100 * (random / edges - 1);
  return vo::concat("At 100 %: ", what, " ", format_decimals(edges, 2), " ", unit, " with edges, ",
                    format_decimals(random, 2), " with as many random pixels (",
                    format_decimals(std::abs(percent), 1),
                    percent < 0 ? " % less), " : " % more), ", format_decimals(all, 2),
                    " with all pixels.");
}

/// Returns a sentence on the number of shares at which edges beat random pixels, and at which by
/// more than the standard deviations over seeds.
std::string count_wins(const std::vector<PointsSample>& samples, double ClipScore::*value,
                       const char* what) {
  int wins = 0;
  int clear_wins = 0;
  int clear_losses = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
    const Spread edges = samples[i].spread_of(value);
    const Spread random = samples[i + 1].spread_of(value);
    const double gain = random.mean - edges.mean;
    const double scatter = edges.deviation + random.deviation;
    wins += gain > 0 ? 1 : 0;
    clear_wins += gain > scatter ? 1 : 0;
    clear_losses += gain < -scatter ? 1 : 0;
  }
  return vo::concat(
      "Edges have the smaller ", what, " at ", wins, " of ", kPointPercents.size(), " shares, at ",
      clear_wins, " by more than both standard deviations; random pixels are better by as much at ",
      clear_losses, ".");
}

std::vector<std::string> points_findings(const std::vector<PointsSample>& samples) {
  const std::size_t n = samples.size();
  const auto mean = [&](std::size_t back, double ClipScore::*value) {
    return samples[n - back].spread_of(value).mean;
  };
  const auto at_full = [&](const char* what, const char* unit, double ClipScore::*value) {
    return compared(what, unit, mean(3, value), mean(2, value), mean(1, value));
  };
  return {count_wins(samples, &ClipScore::rpe_mm, "RPE"),
          count_wins(samples, &ClipScore::ate_mm, "ATE"),
          at_full("RPE", "mm/s", &ClipScore::rpe_mm), at_full("ATE", "mm", &ClipScore::ate_mm),
          at_full("processor time per frame", "ms", &ClipScore::ms_per_frame)};
}

}  // namespace

StudyReport study_points(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress) {
  const std::vector<PointsSample> samples = points_measure(clip, settings, progress);
  return {.name = "points",
          .title = "Edge pixels against random pixels against all pixels: " + clip.name,
          .method = vo::concat(
              clip.frames.size(),
              " frames, a keyframe every 4, search from the last pose (no "
              "constant motion), ",
              settings.seeds, " seeds, ", settings.described(),
              ". Random pixels are drawn anywhere with depth, as many per pyramid level as there "
              "are edge pixels with depth; a share of either is drawn at random too. RPE is the "
              "RMSE over one second, sd the standard deviation over seeds, time the "
              "median processor time per frame with pyramid, edges and choice of points."),
          .table = points_make_table(samples),
          .findings = points_findings(samples),
          .plot = draw_plot("Accuracy and time against number of points: " + clip.name,
                            {points_make_panel(samples, &ClipScore::rpe_mm, "RPE, mm/s"),
                             points_make_panel(samples, &ClipScore::ate_mm,
                                               ate_title("mm", vo::TrajectoryAlignment::se3)),
                             points_make_panel(samples, &ClipScore::ms_per_frame,
                                               "processor time per frame, ms")}),
          .more = {}};
}

}  // namespace tools
