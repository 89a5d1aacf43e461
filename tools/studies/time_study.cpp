#include <algorithm>
#include <array>
#include <limits>

#include "tools/plot/linear_fit.h"
#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/studies/study.h"
#include "vo/alignment/align.h"
#include "vo/core/error.h"
#include "vo/core/processor_time.h"
#include "vo/core/stopwatch.h"

namespace tools {
namespace {

constexpr std::array kTimePercents{5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
constexpr std::size_t kTimedPairs = 8;  // greatest number of pairs

/// Means over the pairs for one share of one selection.
struct TimeSample {
  double percent = 0;
  double points = 0;      ///< number of points of the finest level
  double iterations = 0;  ///< iterations over all levels
  double ms = 0;          ///< time of one alignment
  double ms_per_iteration = 0;
};

struct Selection {
  std::string name;
  std::vector<TimeSample> samples;

  LinearFit fit(double TimeSample::*value) const {
    std::vector<double> points;
    std::vector<double> times;
    for (const TimeSample& sample : samples) {
      points.push_back(sample.points);
      times.push_back(sample.*value);
    }
    return fit_line(points, times).value_or(LinearFit{kUnknown, kUnknown, kUnknown});
  }
};

struct Prepared {
  vo::FramePyramid reference;
  vo::FramePyramid current;
};

double least_ms(const vo::EdgePoints& points, const vo::FramePyramid& current,
                const vo::AlignOptions& options) {
  constexpr int kRepetitions = 3;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRepetitions; ++i) {
    const vo::CpuStopwatch watch;
    vo::align(points, current, {}, options);
    least = std::min(least, watch.elapsed_ms());
  }
  return least;
}

TimeSample time_measure(const std::vector<Prepared>& pairs, const vo::TrackerOptions& options) {
  TimeSample sample{.percent = 100 * options.points.fraction};
  const auto count = static_cast<double>(pairs.size());
  for (const Prepared& pair : pairs) {
    const vo::EdgePoints points = vo::edge_points(pair.reference, pair.current, options.points);
    const vo::AlignResult result = vo::align(points, pair.current, {}, options.align);
    // Every level is evaluated once before its first iteration.
    const double evaluations = result.iterations + static_cast<double>(points.levels.size());
    const double ms = least_ms(points, pair.current, options.align);
    sample.points += static_cast<double>(points.levels[0].size()) / count;
    sample.iterations += result.iterations / count;
    sample.ms += ms / count;
    sample.ms_per_iteration += ms / evaluations / count;
  }
  return sample;
}

std::vector<Selection> measure_all(const std::vector<Prepared>& pairs,
                                   const StudySettings& settings, const vo::Progress& progress) {
  std::vector<Selection> selections = {{"edges", {}}, {"all", {}}};
  std::size_t done = 0;
  for (Selection& selection : selections) {
    for (const int percent : kTimePercents) {
      selection.samples.push_back(time_measure(
          pairs, settings.options({}, {{"points.selection", selection.name},
                                       {"points.fraction", vo::concat(percent / 100.0)}})));
      progress(++done, selections.size() * kTimePercents.size());
    }
  }
  return selections;
}

Table time_make_table(const std::vector<Selection>& selections) {
  Table table{.columns = {{"selection"},
                          {"percent"},
                          {"points"},
                          {"iterations", 1},
                          {"alignment_ms", 3},
                          {"iteration_ms", 4}}};
  for (const Selection& selection : selections) {
    for (const TimeSample& sample : selection.samples) {
      table.add_row({selection.name, sample.percent, sample.points, sample.iterations, sample.ms,
                     sample.ms_per_iteration});
    }
  }
  return table;
}

std::string time_finding(const Selection& selection, double TimeSample::*value,
                         const std::string& what) {
  constexpr double kLinear = 0.99;
  constexpr double kNsPerMs = 1e6;
  const LinearFit fit = selection.fit(value);
  return vo::concat("Time of ", what, ", ", selection.name, ": ", format_decimals(fit.intercept, 3),
                    " ms + ", format_decimals(kNsPerMs * fit.slope, 1),
                    " ns per point of the finest level, "
                    "R^2 = ",
                    format_decimals(fit.r_squared, 4),
                    fit.r_squared >= kLinear ? ": linear." : ": not linear.");
}

PlotPanel time_make_panel(const Selection& selection, double TimeSample::*value, int style,
                          const std::string& what) {
  const LinearFit fit = selection.fit(value);
  PlotSeries measured{selection.name + ", measured", style, PlotMark::points, {}};
  for (const TimeSample& sample : selection.samples) {
    measured.points.push_back({sample.points, sample.*value});
  }
  PlotSeries line{selection.name + ", least squares", style, PlotMark::line, {}};
  const double most = selection.samples.back().points;
  line.points = {{0, fit.intercept}, {most, fit.intercept + fit.slope * most}};
  return {.x = {.title = "points of the finest level", .include = {0, most}},
          .y = {.title = what + ", ms", .include = {0, 1e-6}},
          .series = {line, measured}};
}

}  // namespace

StudyReport study_time(const Clip& clip, const StudySettings& settings,
                       const vo::Progress& progress) {
  const vo::TrackerOptions options = settings.options({}, {});
  std::vector<Prepared> pairs;
  for (const FramePair& pair : pairs_apart(clip, 1, kTimedPairs)) {
    pairs.push_back({pyramid_of(clip.frames[pair.ref], clip.camera, options),
                     pyramid_of(clip.frames[pair.cur], clip.camera, options)});
  }
  vo::require(!pairs.empty(), clip.name, ": expected at least two frames with known poses");
  const std::vector<Selection> selections = measure_all(pairs, settings, progress);
  std::vector<std::string> findings;
  for (const Selection& selection : selections) {
    findings.push_back(time_finding(selection, &TimeSample::ms_per_iteration, "one evaluation"));
    findings.push_back(time_finding(selection, &TimeSample::ms, "an alignment"));
  }
  return {.name = "time",
          .title = "Time of an alignment against its number of points: " + clip.name,
          .method = vo::concat(
              pairs.size(), " pairs of consecutive frames aligned from identity, ",
              settings.described(),
              ", least processor time of three repetitions, choice of the points not included. An "
              "alignment's time "
              "is that of one evaluation times their number, which changes with the points too."),
          .table = time_make_table(selections),
          .findings = findings,
          .plot = draw_plot(
              "Time against number of points: " + clip.name,
              {time_make_panel(selections[0], &TimeSample::ms_per_iteration, 0, "one evaluation"),
               time_make_panel(selections[1], &TimeSample::ms_per_iteration, 2, "one evaluation"),
               time_make_panel(selections[0], &TimeSample::ms, 0, "an alignment")}),
          .more = {}};
}

}  // namespace tools
