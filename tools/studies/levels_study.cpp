#include <algorithm>
#include <array>

#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/studies/study.h"
#include "vo/alignment/align.h"
#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::array<std::size_t, 5> kDistances{1, 2, 4, 8, 16};  // frames
constexpr std::size_t kPairs = 24;  // greatest number of pairs per distance
constexpr int kMaxLevels = 6;

/// Results of all pairs of one distance. samples[l] has l + 1 levels.
struct Distance {
  std::size_t frames = 0;
  double flow_px = 0;  ///< mean optical flow of the pairs
  std::array<PairScores, kMaxLevels> samples;
};

template <typename Levels>
void keep_finest(Levels& levels, int count) {
  levels.resize(std::min(levels.size(), static_cast<std::size_t>(count)));
}

void align_pair(const Clip& clip, const FramePair& pair, const StudySettings& settings,
                Distance& distance) {
  const vo::TrackerOptions options =
      settings.options({}, {{"pyramid.levels", vo::concat(kMaxLevels)}});
  const vo::FramePyramid reference = pyramid_of(clip.frames[pair.ref], clip.camera, options);
  vo::FramePyramid current = pyramid_of(clip.frames[pair.cur], clip.camera, options);
  vo::EdgePoints points = vo::edge_points(reference, current, options.points);
  for (int levels = kMaxLevels; levels >= 1; --levels) {
    keep_finest(current.levels, levels);
    keep_finest(points.levels, levels);
    const vo::AlignResult result = vo::align(points, current, {}, options.align);
    const PoseError error = pose_error(pair.T_cur_ref, result.T_cur_ref);
    PairScores& sample = distance.samples.at(static_cast<std::size_t>(levels - 1));
    sample.add(error, result);
    sample.converged += result.usable() && settings.accepts(error) ? 1 : 0;
  }
}

Distance levels_measure(const Clip& clip, const std::vector<FramePair>& pairs,
                        const StudySettings& settings) {
  constexpr int kStep = 4;  // px
  Distance distance{.frames = pairs.front().cur - pairs.front().ref};
  for (const FramePair& pair : pairs) {
    distance.flow_px +=
        mean_flow_px(clip.frames[pair.ref].depth, clip.camera, pair.T_cur_ref, kStep) /
        static_cast<double>(pairs.size());
    align_pair(clip, pair, settings, distance);
  }
  return distance;
}

Table levels_make_table(const std::vector<Distance>& distances) {
  Table table{.columns = {{"frames_apart"},
                          {"flow_px", 1},
                          {"levels"},
                          {"pairs"},
                          {"converged_percent"},
                          {"median_error_mm", 2},
                          {"median_error_deg", 3},
                          {"mean_iterations", 1}}};
  for (const Distance& distance : distances) {
    for (std::size_t l = 0; l < distance.samples.size(); ++l) {
      const PairScores& sample = distance.samples.at(l);
      table.add_row({static_cast<double>(distance.frames), distance.flow_px,
                     static_cast<double>(l + 1), static_cast<double>(sample.mm.size()),
                     sample.percent(), median(sample.mm), median(sample.deg),
                     spread(sample.iterations).mean});
    }
  }
  return table;
}

PlotSeries levels_series_of(const Distance& distance, int style,
                            double (*value)(const PairScores&)) {
  PlotSeries series{vo::concat(distance.frames, distance.frames == 1 ? " frame" : " frames",
                               " apart, ", format_decimals(distance.flow_px, 0), " px"),
                    style,
                    PlotMark::line_and_points,
                    {}};
  for (std::size_t l = 0; l < distance.samples.size(); ++l) {
    series.points.push_back({static_cast<double>(l + 1), value(distance.samples.at(l))});
  }
  return series;
}

std::string levels_draw(const Clip& clip, const std::vector<Distance>& distances) {
  const PlotAxis levels{.title = "pyramid levels", .include = {1, kMaxLevels}};
  PlotPanel converged{.x = levels, .y = {.title = "converged pairs, %", .include = {0, 100}}};
  PlotPanel error{.x = levels,
                  .y = {.title = "median position error, mm", .scale = AxisScale::logarithmic}};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const int style = static_cast<int>(i);
    converged.series.push_back(
        levels_series_of(distances[i], style, [](const PairScores& s) { return s.percent(); }));
    error.series.push_back(
        levels_series_of(distances[i], style, [](const PairScores& s) { return median(s.mm); }));
  }
  return draw_plot("Depth of the pyramid against convergence: " + clip.name, {converged, error});
}

/// Returns a sentence with the share of all pairs that converges with each number of levels.
std::string totals(const std::vector<Distance>& distances) {
  std::string text = "Converged, all distances together:";
  for (std::size_t l = 0; l < kMaxLevels; ++l) {
    double converged = 0;
    double total = 0;
    for (const Distance& distance : distances) {
      converged += distance.samples.at(l).converged;
      total += static_cast<double>(distance.samples.at(l).mm.size());
    }
    text += vo::concat(l == 0 ? " " : ", ", format_decimals(100 * converged / total, 0), " % with ",
                       l + 1, l == 0 ? " level" : "");
  }
  return text + ".";
}

}  // namespace

StudyReport study_levels(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress) {
  std::vector<Distance> distances;
  for (std::size_t i = 0; i < kDistances.size(); ++i) {
    const std::vector<FramePair> pairs = pairs_apart(clip, kDistances.at(i), kPairs);
    if (!pairs.empty()) {
      distances.push_back(levels_measure(clip, pairs, settings));
    }
    progress(i + 1, kDistances.size());
  }
  vo::require(!distances.empty(), clip.name, ": expected at least two frames with known poses");
  return {
      .name = "levels",
      .title = "Depth of the pyramid against convergence: " + clip.name,
      .method = vo::concat(
          "Pairs of frames spread over the sequence, aligned from identity, ", settings.described(),
          ". Converged: less than ", 1000 * settings.max_error, " mm and ", settings.max_error_deg,
          " deg from the truth. The flow is the pairs' mean displacement of pixels with depth."),
      .table = levels_make_table(distances),
      .findings = {totals(distances)},
      .plot = levels_draw(clip, distances),
      .more = {}};
}

}  // namespace tools
