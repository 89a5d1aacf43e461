#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tools/plot/plot.h"
#include "tools/plot/statistics.h"
#include "tools/scenario/error_titles.h"
#include "tools/studies/alterations.h"
#include "tools/studies/study.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/sequence_odometry/track_sequence.h"

namespace tools {
namespace {

/// Holds what a tracker says of an altered clip, and how true it is. Poses are sure unless they are
/// marked as uncertain.
struct StressScore {
  double sure_percent = 0;       ///< frames with a sure pose
  double uncertain_percent = 0;  ///< frames with an uncertain pose
  ClipErrors all;                ///< errors of all poses
  ClipErrors sure;               ///< errors of the sure ones
  double steps = 0;  ///< motions between consecutive sure poses that are off by more than 3 cm
  double sigma_mm = kUnknown;  ///< median standard deviation claimed for a sure position
  std::string readout;         ///< read-out time and lines, as estimated in the end
  std::string reasons;         ///< why frames are lost or uncertain, and how many
};

/// Returns the number of motions from frame to frame that are off by more than 3 cm.
double wrong_steps(const vo::Trajectory& truth, const vo::Trajectory& estimate) {
  constexpr double kWrong = 0.03;       // m
  constexpr double kLongestStep = 0.2;  // s, frames between two were lost or uncertain
  double wrong = 0;
  for (std::size_t i = 1; i < estimate.size(); ++i) {
    if (estimate[i].timestamp - estimate[i - 1].timestamp > kLongestStep) {
      continue;
    }
    const auto T_world_before = vo::pose_at(truth, estimate[i - 1].timestamp);
    const auto T_world_now = vo::pose_at(truth, estimate[i].timestamp);
    if (T_world_before && T_world_now) {
      const vo::SE3 step = estimate[i - 1].T_world_camera.inverse() * estimate[i].T_world_camera;
      const vo::SE3 error = (T_world_before->inverse() * *T_world_now).inverse() * step;
      wrong += error.translation().norm() > kWrong ? 1 : 0;
    }
  }
  return wrong;
}

/// Returns the reasons with the frames that have them, the most frequent first.
std::string most_frequent_first(const std::map<vo::TrackingReason, std::size_t>& counts) {
  std::vector<std::pair<vo::TrackingReason, std::size_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [reason, frames] : sorted) {
    text += vo::concat(text.empty() ? "" : ", ", vo::to_string(reason), " ", frames);
  }
  return text.empty() ? "-" : text;
}

double sigma_of(const vo::AlignResult& alignment) {
  return kMmPerM * std::sqrt(alignment.covariance.topLeftCorner<3, 3>().trace());
}

StressScore stressed(const Clip& clip, const vo::TrackerOptions& options) {
  vo::RgbdOdometry odometry(clip.camera, options);
  vo::SequenceResult tracked;
  std::vector<double> sigmas_mm;
  vo::Trajectory sure;
  for (const vo::RgbdFrame& frame : clip.frames) {
    const vo::TrackingResult& result = tracked.frames.emplace_back(odometry.track(frame));
    if (result.status == vo::TrackingStatus::tracked) {
      sure.push_back({frame.timestamp, result.T_world_camera});
      sigmas_mm.push_back(sigma_of(result.alignment));
    }
  }
  const vo::Readout readout = odometry.tracker().readout();
  const double percent = 100 / static_cast<double>(clip.frames.size());
  const std::size_t poses = odometry.trajectory().size();
  return {.sure_percent = percent * static_cast<double>(poses - tracked.uncertain()),
          .uncertain_percent = percent * static_cast<double>(tracked.uncertain()),
          .all = errors_of(clip.truth, odometry.trajectory()),
          .sure = errors_of(clip.truth, sure),
          .steps = wrong_steps(clip.truth, sure),
          .sigma_mm = median(sigmas_mm),
          .readout = vo::concat(format_decimals(1000 * readout.seconds, 1), " ms, ",
                                vo::to_string(readout.axis)),
          .reasons = most_frequent_first(tracked.reasons())};
}

}  // namespace

StudyReport study_stress(const Clip& clip, const StudySettings& settings,
                         const vo::Progress& progress) {
  const vo::TrackerOptions options = settings.options({}, {});
  StudyReport report{
      .name = "stress",
      .title = "A clip altered: " + clip.name,
      .method = vo::concat("The whole clip is tracked as it was recorded and altered, ",
                           settings.described(),
                           ". RPE and ATE are those of all poses. A sure pose is not marked as "
                           "uncertain: worst is the greatest error of any, a wrong step a motion "
                           "between two in a row that is off by more than 3 cm, sigma what the "
                           "tracker claims of a position.")};
  report.table.columns = {{"alteration"},  {"sure_percent", 1}, {"uncertain_percent", 1},
                          {"rpe_mm", 1},   {"ate_mm", 1},       {"worst_sure_mm", 1},
                          {"wrong_steps"}, {"sigma_mm", 2},     {"readout"},
                          {"reasons"}};
  const std::span<const Alteration> all = alterations();
  PlotSeries errors{"", 0, PlotMark::points, {}};
  PlotAxis x{.title = "alteration"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    Clip changed = clip;
    all[i].apply(changed);
    const StressScore score = stressed(changed, options);
    report.table.add_row({std::string(all[i].description), score.sure_percent,
                          score.uncertain_percent, score.all.rpe_mm, score.all.ate_mm,
                          score.sure.worst_mm, score.steps, score.sigma_mm, score.readout,
                          score.reasons});
    errors.points.push_back({static_cast<double>(i), score.all.ate_mm});
    x.categories.emplace_back(all[i].name);
    progress(i + 1, all.size());
  }
  report.plot =
      draw_plot(report.title, {{.x = x,
                                .y = {.title = ate_title("mm", vo::TrajectoryAlignment::se3),
                                      .scale = AxisScale::logarithmic},
                                .series = {errors}}});
  return report;
}

}  // namespace tools
