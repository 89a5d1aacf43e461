#include "tools/studies/basin.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/processes/job_pool.h"
#include "vo/alignment/align.h"
#include "vo/core/error.h"

namespace tools {
namespace {

/// A pair of frames ready to be aligned.
struct AlignPair {
  vo::EdgePoints points;
  vo::FramePyramid current;
  vo::SE3 T_cur_ref;  ///< ground truth
};

/// One cell of the map: the alignments of all pairs with one translational and rotational offset.
struct BasinCell {
  double translation = 0;   ///< m
  double rotation_deg = 0;  ///< deg
  PairScores scores;
};

/// Returns one of `count` directions spread evenly over the sphere by a golden-angle spiral.
Eigen::Vector3d direction(std::size_t index, std::size_t count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  const double z = 1 - (2 * static_cast<double>(index) + 1) / static_cast<double>(count);
  const double radius = std::sqrt(1 - z * z);
  const double angle = golden * static_cast<double>(index);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<AlignPair> make_pairs(const Clip& clip, const BasinSettings& settings) {
  std::vector<AlignPair> pairs;
  for (const FramePair& pair : pairs_apart(clip, static_cast<std::size_t>(settings.apart),
                                           static_cast<std::size_t>(settings.pairs))) {
    const vo::FramePyramid reference =
        pyramid_of(clip.frames[pair.ref], clip.camera, settings.tracker);
    vo::FramePyramid current = pyramid_of(clip.frames[pair.cur], clip.camera, settings.tracker);
    vo::EdgePoints points = vo::edge_points(reference, current, settings.tracker.points);
    pairs.push_back({std::move(points), std::move(current), pair.T_cur_ref});
  }
  vo::require(!pairs.empty(), clip.name, ": expected frames with known poses ", settings.apart,
              " apart");
  return pairs;
}

void measure(const std::vector<AlignPair>& pairs, const BasinSettings& settings, BasinCell& cell) {
  constexpr std::size_t kStride = 5;  // decorrelates rotation axis and translation
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    vo::Vector6d offset;
    offset << cell.translation * direction(i, pairs.size()),
        cell.rotation_deg * std::numbers::pi / 180 *
            direction(i * kStride % pairs.size(), pairs.size());
    const vo::SE3 guess = vo::SE3::exp(offset) * pairs[i].T_cur_ref;
    const vo::AlignResult result =
        vo::align(pairs[i].points, pairs[i].current, guess, settings.tracker.align);
    const PoseError error = pose_error(pairs[i].T_cur_ref, result.T_cur_ref);
    cell.scores.add(error, result);
    const bool is_near =
        error.mm < kMmPerM * settings.max_error && error.deg < settings.max_error_deg;
    cell.scores.converged += result.usable() && is_near ? 1 : 0;
  }
}

double percent(const BasinCell& cell) {
  return cell.scores.percent();
}

/// Returns the cells row by row; the translation grows within a row, the rotation from row to row.
std::vector<BasinCell> make_cells(const BasinSettings& settings) {
  std::vector<BasinCell> cells;
  for (int i = 0; i < settings.steps; ++i) {
    for (int j = 0; j < settings.steps; ++j) {
      const double step = settings.steps - 1;
      cells.push_back({.translation = settings.max_translation * j / step,
                       .rotation_deg = settings.max_rotation_deg * i / step,
                       .scores = {}});
    }
  }
  return cells;
}

Table make_table(const std::vector<BasinCell>& cells) {
  Table table{.columns = {{"offset_mm", 0},
                          {"offset_deg", 1},
                          {"converged_percent", 0},
                          {"median_error_mm", 2},
                          {"median_error_deg", 3}}};
  for (const BasinCell& cell : cells) {
    table.add_row({kMmPerM * cell.translation, cell.rotation_deg, percent(cell),
                   median(cell.scores.mm), median(cell.scores.deg)});
  }
  return table;
}

PlotPanel make_map(const std::vector<BasinCell>& cells, std::size_t steps,
                   double (*value)(const BasinCell&)) {
  PlotPanel map{.x = {.title = "offset of the start, mm"},
                .y = {.title = "offset of the start, deg"}};
  for (std::size_t i = 0; i < steps; ++i) {
    map.x.categories.push_back(tick_label(std::round(kMmPerM * cells[i].translation)));
    map.y.categories.push_back(tick_label(cells[i * steps].rotation_deg));
    map.cells.values.emplace_back();
    for (std::size_t j = 0; j < steps; ++j) {
      map.cells.values.back().push_back(value(cells[i * steps + j]));
    }
  }
  return map;
}

std::string draw(const std::string& title, const std::vector<BasinCell>& cells, int steps) {
  const auto count = static_cast<std::size_t>(steps);
  PlotPanel converged = make_map(cells, count, percent);
  converged.colours = {.title = "converged, %", .range = {0, 100}};
  PlotPanel error =
      make_map(cells, count, [](const BasinCell& cell) { return median(cell.scores.mm); });
  error.colours = {
      .title = "median position error, mm", .range = {0.1, 100}, .scale = AxisScale::logarithmic};
  error.cells.decimals = 1;
  return draw_plot(title, {converged, error});
}

/// Returns the greatest offset along one axis of the map up to which 90 % of alignments converge.
double reach(const std::vector<BasinCell>& cells, int steps, int stride,
             double BasinCell::*offset) {
  constexpr double kEnough = 90;
  double greatest = 0;
  for (int i = 0; i < steps; ++i) {
    const BasinCell& cell = cells[static_cast<std::size_t>(i) * static_cast<std::size_t>(stride)];
    if (percent(cell) < kEnough) {
      break;
    }
    greatest = cell.*offset;
  }
  return greatest;
}

}  // namespace

void BasinSettings::validate() const {
  constexpr int kMaxSteps = 50;
  tracker.validate();
  vo::require(pairs >= 1, "--pairs: expected at least 1, got ", pairs);
  vo::require(apart >= 1, "--apart: expected at least 1, got ", apart);
  vo::require(steps >= 2 && steps <= kMaxSteps, "--steps: expected 2 to ", kMaxSteps, ", got ",
              steps);
  vo::require(max_translation > 0 && max_rotation_deg > 0,
              "--max-translation, --max-rotation-deg: expected above 0");
  vo::require(max_error > 0 && max_error_deg > 0, "--max-error, --max-error-deg: expected above 0");
}

StudyReport study_basin(const Clip& clip, const BasinSettings& settings,
                        const vo::Progress& progress) {
  const std::vector<AlignPair> pairs = make_pairs(clip, settings);
  std::vector<BasinCell> cells = make_cells(settings);
  std::mutex mutex;
  std::size_t done = 0;
  run_jobs(cells.size(), settings.jobs, [&](std::size_t i) {
    measure(pairs, settings, cells[i]);
    const std::lock_guard lock(mutex);
    progress(++done, cells.size());
  });
  const std::string title = "Basin of convergence: " + clip.name;
  const int steps = settings.steps;
  return {
      .name = "basin",
      .title = title,
      .method = vo::concat(
          pairs.size(), " pairs of frames, ", settings.apart,
          " apart, aligned from the truth moved and turned by offsets, each pair in a direction of "
          "its own. Converged: within ",
          kMmPerM * settings.max_error, " mm and ", settings.max_error_deg, " deg of the truth."),
      .table = make_table(cells),
      .findings = {vo::concat(
          "Nine of ten alignments converge up to ",
          format_decimals(kMmPerM * reach(cells, steps, 1, &BasinCell::translation), 0),
          " mm, and up to ",
          format_decimals(reach(cells, steps, steps, &BasinCell::rotation_deg), 1), " deg.")},
      .plot = draw(title, cells, steps),
      .more = {}};
}

}  // namespace tools
