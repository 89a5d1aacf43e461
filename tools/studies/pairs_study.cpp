#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/studies/pose_pairs.h"
#include "tools/studies/study.h"
#include "vo/core/error.h"
#include "vo/tracking/tracker.h"

namespace tools {
namespace {

/// Returns the variants of the alignment that the study compares.
std::vector<Variant> pair_variants() {
  return {
      {"as given", {}},
      {"the paper: new image, Otsu, 3 levels",
       {{"points.source", "current"}, {"edges.threshold", "otsu"}, {"pyramid.levels", "3"}}},
      {"edges of the new image, 3 levels", {{"points.source", "current"}, {"pyramid.levels", "3"}}},
      {"edges of the new image, 5 levels", {{"points.source", "current"}, {"pyramid.levels", "5"}}},
      {"edges of the reference, 3 levels",
       {{"points.source", "reference"}, {"pyramid.levels", "3"}}},
      {"edges of the reference, 5 levels",
       {{"points.source", "reference"}, {"pyramid.levels", "5"}}},
      {"random pixels, 3 levels",
       {{"points.source", "reference"}, {"points.selection", "random"}, {"pyramid.levels", "3"}}},
      {"all pixels, 5 levels",
       {{"points.selection", "all"}, {"points.max_points", "0"}, {"pyramid.levels", "5"}}},
      {"forward, 5 levels", {{"align.formulation", "forward"}, {"pyramid.levels", "5"}}},
      {"inverse, 5 levels", {{"align.formulation", "inverse"}, {"pyramid.levels", "5"}}},
      {"all edge points", {{"points.max_points", "0"}}},
      {"no edge point within 2 px of a depth step",
       {{"points.max_points", "0"}, {"points.discontinuity_radius", "2"}}},
  };
}

/// Results of one variant; samples[i] belongs to the i-th mean flow.
struct VariantResult {
  std::string name;
  std::vector<PairScores> samples;
};

/// Aligns a pair as the tracker would with one keyframe, seen last, and a camera at rest.
void align_pair(const vo::FramePyramid& reference, const vo::FramePyramid& current,
                const vo::SE3& T_true, const vo::TrackerOptions& options,
                const StudySettings& settings, PairScores& sample) {
  vo::Tracker tracker(options);
  tracker.track(reference);
  tracker.set_keyframe(reference, {});
  const vo::TrackingResult result = tracker.track(current);
  const PoseError error = pose_error(T_true, result.T_world_camera.inverse());
  sample.add(error, result.alignment);
  const bool tracked = result.status == vo::TrackingStatus::tracked;
  sample.converged += tracked && settings.accepts(error) ? 1 : 0;
}

VariantResult pairs_measure(const Clip& clip, const Variant& variant, std::size_t group,
                            const StudySettings& settings) {
  const vo::TrackerOptions options = settings.options({}, variant.changes);
  VariantResult result{variant.name, std::vector<PairScores>(group - 1)};
  for (std::size_t first = 0; first + group <= clip.frames.size(); first += group) {
    const vo::FramePyramid reference = pyramid_of(clip.frames[first], clip.camera, options);
    for (std::size_t i = 1; i < group; ++i) {
      const vo::FramePyramid current = pyramid_of(clip.frames[first + i], clip.camera, options);
      const vo::SE3 T_true =
          clip.truth[first + i].T_world_camera.inverse() * clip.truth[first].T_world_camera;
      align_pair(reference, current, T_true, options, settings, result.samples[i - 1]);
    }
  }
  return result;
}

/// Returns the mean flow of each motion size over the full images, px.
std::vector<double> measured_flows(const Clip& clip, std::size_t group) {
  constexpr int kStep = 4;  // px
  std::vector<double> flows;
  for (std::size_t i = 1; i < group; ++i) {
    std::vector<double> of_pairs;
    for (std::size_t first = 0; first + group <= clip.frames.size(); first += group) {
      const vo::SE3 T_cur_ref =
          clip.truth[first + i].T_world_camera.inverse() * clip.truth[first].T_world_camera;
      of_pairs.push_back(mean_flow_px(clip.frames[first].depth, clip.camera, T_cur_ref, kStep));
    }
    flows.push_back(spread(of_pairs).mean);
  }
  return flows;
}

double mean_depth(const Clip& clip, std::size_t group) {
  std::vector<double> depths;
  for (std::size_t first = 0; first < clip.frames.size(); first += group) {
    const vo::DepthImage& depth = clip.frames[first].depth;
    depths.push_back(cv::mean(depth, depth > 0)[0]);
  }
  return spread(depths).mean;
}

Table pairs_make_table(const std::vector<VariantResult>& results,
                       const std::vector<double>& flows) {
  Table table{.columns = {{"variant"},
                          {"flow_px", 1},
                          {"points"},
                          {"median_error_mm", 3},
                          {"median_error_deg", 4},
                          {"converged"},
                          {"pairs"}}};
  for (const VariantResult& result : results) {
    for (std::size_t i = 0; i < flows.size(); ++i) {
      const PairScores& sample = result.samples[i];
      table.add_row({result.name, flows[i], spread(sample.points).mean, median(sample.mm),
                     median(sample.deg), 1.0 * sample.converged,
                     static_cast<double>(sample.mm.size())});
    }
  }
  return table;
}

std::string pairs_draw(const Clip& clip, const std::vector<VariantResult>& results,
                       const std::vector<double>& flows) {
  const PlotAxis flow{.title = "mean flow, px", .include = {0, 45}};
  PlotPanel converged{.x = flow, .y = {.title = "converged pairs, %", .include = {0, 100}}};
  PlotPanel error{.x = flow,
                  .y = {.title = "median position error, mm", .scale = AxisScale::logarithmic}};
  for (std::size_t v = 0; v < results.size(); ++v) {
    PlotSeries percent{results[v].name, static_cast<int>(v), PlotMark::line_and_points, {}};
    PlotSeries mm = percent;
    for (std::size_t i = 0; i < flows.size(); ++i) {
      percent.points.push_back({flows[i], results[v].samples[i].percent()});
      mm.points.push_back({flows[i], median(results[v].samples[i].mm)});
    }
    converged.series.push_back(percent);
    error.series.push_back(mm);
  }
  return draw_plot("Random pairs from identity: " + clip.name, {converged, error});
}

/// Compares a variant with the project's goals for pairs with 12, 27 and 42 px of flow.
std::string judged(const VariantResult& result) {
  constexpr double kGoalMm = 0.2;
  constexpr double kGoalDeg = 0.004;
  constexpr double kGoalPercent = 95;
  const PairScores& at_12 = result.samples[1];
  const PairScores& at_27 = result.samples[2];
  const PairScores& at_42 = result.samples[3];
  const auto mark = [](bool met) { return met ? " (met)" : " (missed)"; };
  const double mm = median(at_12.mm);
  const double deg = median(at_12.deg);
  return vo::concat(result.name, ": 12 px ", format_decimals(mm, 3), " mm, ",
                    format_decimals(deg, 4), " deg", mark(mm <= kGoalMm && deg <= kGoalDeg),
                    "; 27 px ", format_decimals(at_27.percent(), 0), " %",
                    mark(at_27.percent() == 100), "; 42 px ", format_decimals(at_42.percent(), 0),
                    " %", mark(at_42.percent() >= kGoalPercent), ".");
}

}  // namespace

StudyReport study_pairs(const Clip& clip, const StudySettings& settings,
                        const vo::Progress& progress) {
  const std::size_t group = PosePairOptions{}.poses_per_view();
  const std::vector<double> flows = measured_flows(clip, group);
  std::vector<VariantResult> results;
  std::vector<std::string> findings = {
      "Goals: 0.2 mm and 0.004 deg at 12 px, all pairs at 27 px, 95 % at 42 px."};
  for (const Variant& variant : pair_variants()) {
    results.push_back(pairs_measure(clip, variant, group, settings));
    findings.push_back(judged(results.back()));
    progress(results.size(), pair_variants().size());
  }
  return {.name = "pairs",
          .title = "Random pairs aligned from identity: " + clip.name,
          .method = vo::concat(
              clip.frames.size() / group,
              " random textured views, each moved in random directions by ", group - 1,
              " mean flows, translation and rotation causing about half of it each; mean "
              "depth ",
              format_decimals(mean_depth(clip, group), 2), " m; ", settings.described(),
              ". Converged: less than ", 1000 * settings.max_error, " mm and ",
              settings.max_error_deg, " deg from the truth. Medians are over all pairs."),
          .table = pairs_make_table(results, flows),
          .findings = findings,
          .plot = pairs_draw(clip, results, flows),
          .more = {}};
}

}  // namespace tools
