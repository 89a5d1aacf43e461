#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <opencv2/imgproc.hpp>

#include "tools/pictures/panels.h"
#include "tools/pictures/pictures.h"
#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/studies/study.h"
#include "vo/alignment/align.h"
#include "vo/core/error.h"
#include "vo/image_files/png.h"
#include "vo/residuals/linearize.h"

namespace tools {
namespace {

constexpr std::size_t kCompared = 5;     // frames
constexpr std::size_t kReferences = 12;  // greatest number of references
constexpr std::size_t kGreyLevels = 256;
constexpr int kPictureWidth = 320;  // px

/// Number of pixels by |residual| in whole grey levels.
struct Histogram {
  std::array<double, kGreyLevels> counts{};

  void add(const std::vector<std::optional<float>>& residuals) {
    for (const std::optional<float>& residual : residuals) {
      if (residual) {
        const auto level = static_cast<std::size_t>(std::lround(255 * std::abs(*residual)));
        ++counts.at(std::min(level, kGreyLevels - 1));
      }
    }
  }

  double total() const { return std::accumulate(counts.begin(), counts.end(), 0.0); }

  double mean() const {
    double sum = 0;
    for (std::size_t level = 0; level < kGreyLevels; ++level) {
      sum += counts.at(level) * static_cast<double>(level);
    }
    return sum / total();
  }

  /// Returns the share of pixels whose |residual| is at most `level`, %.
  double percent_within(std::size_t level) const {
    const auto end = counts.begin() + static_cast<std::ptrdiff_t>(level) + 1;
    return 100 * std::accumulate(counts.begin(), end, 0.0) / total();
  }
};

/// Histograms of residuals at one distance from the reference.
struct Stage {
  Histogram before;        ///< all pixels at the reference's pose
  Histogram after_edges;   ///< all pixels after aligning edges
  Histogram after_all;     ///< all pixels after aligning all pixels
  Histogram edges_before;  ///< edge pixels at the reference's pose
  Histogram edges_after;
};

using Pictures = std::vector<cv::Mat_<cv::Vec3b>>;

struct ResidualsOutcome {
  std::array<Stage, kCompared> stages;
  Pictures before;
  Pictures after;
};

std::string frames_apart(std::size_t count) {
  return vo::concat(count, count == 1 ? " frame apart" : " frames apart");
}

cv::Mat_<cv::Vec3b> picture(const vo::EdgePointLevel& points, const vo::PyramidLevel& level,
                            const vo::SE3& T_cur_ref, const std::string& title) {
  const cv::Mat_<cv::Vec3b> full = draw_residuals(points, level, T_cur_ref);
  cv::Mat_<cv::Vec3b> small;
  const int height = std::max(1, kPictureWidth * full.rows / full.cols);
  cv::resize(full, small, {kPictureWidth, height}, 0, 0, cv::INTER_AREA);
  return titled(small, title);
}

/// Follows one reference over the next frames, each search starting at the last result.
void residuals_follow(const Clip& clip, std::size_t first, const StudySettings& settings,
                      ResidualsOutcome& outcome) {
  const vo::TrackerOptions edges = settings.options({}, {{"points.selection", "edges"}});
  const vo::TrackerOptions all = settings.options({}, {{"points.selection", "all"}});
  const vo::FramePyramid reference = pyramid_of(clip.frames[first], clip.camera, edges);
  const vo::EdgePoints pixels = vo::edge_points(reference, reference, all.points);
  const bool pictured = outcome.before.empty();
  vo::SE3 T_edges;
  vo::SE3 T_all;
  for (std::size_t k = 1; k <= kCompared; ++k) {
    const vo::FramePyramid current = pyramid_of(clip.frames[first + k], clip.camera, edges);
    const vo::EdgePoints edge = vo::edge_points(reference, current, edges.points);
    T_edges = vo::align(edge, current, T_edges, edges.align).T_cur_ref;
    T_all = vo::align(pixels, current, T_all, all.align).T_cur_ref;
    Stage& stage = outcome.stages.at(k - 1);
    const vo::PyramidLevel& level = current.levels[0];
    stage.before.add(vo::residuals(pixels.levels[0], level, {}));
    stage.after_edges.add(vo::residuals(pixels.levels[0], level, T_edges));
    stage.after_all.add(vo::residuals(pixels.levels[0], level, T_all));
    stage.edges_before.add(vo::residuals(edge.levels[0], level, {}));
    stage.edges_after.add(vo::residuals(edge.levels[0], level, T_edges));
    if (pictured) {
      const std::string apart = frames_apart(k);
      outcome.before.push_back(picture(pixels.levels[0], level, {}, apart + ", before"));
      outcome.after.push_back(picture(pixels.levels[0], level, T_edges, apart + ", after"));
    }
  }
}

Table residuals_make_table(const ResidualsOutcome& outcome) {
  constexpr std::size_t kSmall = 5;  // grey levels
  Table table{.columns = {{"frames_apart"},
                          {"before_grey", 2},
                          {"after_edges_grey", 2},
                          {"after_all_grey", 2},
                          {"within_5_grey_before_percent", 1},
                          {"within_5_grey_after_edges_percent", 1},
                          {"within_5_grey_after_all_percent", 1},
                          {"edge_pixels_before_grey", 2},
                          {"edge_pixels_after_grey", 2}}};
  for (std::size_t k = 1; k <= kCompared; ++k) {
    const Stage& stage = outcome.stages.at(k - 1);
    table.add_row({static_cast<double>(k), stage.before.mean(), stage.after_edges.mean(),
                   stage.after_all.mean(), stage.before.percent_within(kSmall),
                   stage.after_edges.percent_within(kSmall), stage.after_all.percent_within(kSmall),
                   stage.edges_before.mean(), stage.edges_after.mean()});
  }
  return table;
}

PlotSeries curve(const Histogram& histogram, const std::string& name, int style, PlotMark mark) {
  constexpr std::size_t kShown = 40;  // grey levels
  PlotSeries series{name, style, mark, {}};
  for (std::size_t level = 0; level <= kShown; ++level) {
    series.points.push_back({static_cast<double>(level), histogram.percent_within(level)});
  }
  return series;
}

PlotPanel residuals_make_panel(const ResidualsOutcome& outcome, Histogram Stage::*before,
                               Histogram Stage::*after, const std::string& pixels) {
  PlotPanel panel{
      .x = {.title = "|residual|, grey levels of 255", .include = {0, 40}},
      .y = {.title = "share of " + pixels + " with at most this residual, %", .include = {0, 100}}};
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}, kCompared}) {
    const int style = static_cast<int>(k / 2);
    const std::string apart = frames_apart(k);
    const Stage& stage = outcome.stages.at(k - 1);
    panel.series.push_back(curve(stage.*before, apart + ", before", style, PlotMark::dashes));
    panel.series.push_back(curve(stage.*after, apart + ", after", style, PlotMark::line));
  }
  return panel;
}

/// Returns the histograms behind the curves as CSV.
std::string histogram_csv(const ResidualsOutcome& outcome) {
  Table table{
      .columns = {{"frames_apart"}, {"residual_grey"}, {"before"}, {"after_edges"}, {"after_all"}}};
  for (std::size_t k = 1; k <= kCompared; ++k) {
    const Stage& stage = outcome.stages.at(k - 1);
    for (std::size_t level = 0; level < kGreyLevels; ++level) {
      table.add_row({static_cast<double>(k), static_cast<double>(level),
                     stage.before.counts.at(level), stage.after_edges.counts.at(level),
                     stage.after_all.counts.at(level)});
    }
  }
  return as_csv(table);
}

std::string residuals_finding(const ResidualsOutcome& outcome, std::size_t k) {
  const Stage& stage = outcome.stages.at(k - 1);
  const double before = stage.before.mean();
  const double edges = stage.after_edges.mean();
  const double all = stage.after_all.mean();
  return vo::concat(
      frames_apart(k), ", aligning edges takes the mean |residual| of all pixels from ",
      format_decimals(before, 2), " to ", format_decimals(edges, 2),
      " grey levels; aligning all pixels takes it to ", format_decimals(all, 2), ": edges reach ",
      format_decimals(100 * (before - edges) / (before - all), 1), " % of that reduction.");
}

}  // namespace

StudyReport study_residuals(const Clip& clip, const StudySettings& settings,
                            const vo::Progress& progress) {
  const std::vector<FramePair> pairs = pairs_apart(clip, kCompared, kReferences);
  vo::require(!pairs.empty(), clip.name, ": expected more than ", kCompared,
              " frames with known poses");
  ResidualsOutcome outcome;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    residuals_follow(clip, pairs[i].ref, settings, outcome);
    progress(i + 1, pairs.size());
  }
  return {.name = "residuals",
          .title = "Residuals of all pixels when edges are aligned: " + clip.name,
          .method = vo::concat(
              pairs.size(), " references spread over the sequence, each followed for ", kCompared,
              " frames, ", settings.described(),
              ". Before: at the reference's pose. After: edges (or, to compare, all pixels) "
              "aligned, each search starting from the frame before. Pictures of the first "
              "reference are in `residuals.png`, the histograms in `residuals_histogram.csv`."),
          .table = residuals_make_table(outcome),
          .findings = {residuals_finding(outcome, 1), residuals_finding(outcome, kCompared)},
          .plot = draw_plot(
              "Residuals before and after aligning edges: " + clip.name,
              {residuals_make_panel(outcome, &Stage::before, &Stage::after_edges, "all pixels"),
               residuals_make_panel(outcome, &Stage::edges_before, &Stage::edges_after,
                                    "edge pixels")}),
          .more = {{"residuals.png", vo::encode_png(montage({outcome.before, outcome.after}))},
                   {"residuals_histogram.csv", histogram_csv(outcome)}}};
}

}  // namespace tools
