// make_example_report FILE.html: a report of one scenario of each kind, for the tests that open it.

#include <iostream>
#include <limits>

#include "tests/support/plane_report.h"
#include "tools/report/html_report.h"
#include "vo/core/fields.h"
#include "vo/files/output.h"

namespace {

tools::ScenarioReport passed() {
  tools::ScenarioReport report = support::plane_report(300, 300);
  const vo::TrajectoryErrors errors = vo::evaluate(report.truth, report.estimate);
  report.metrics = {{"ate_rmse_m", errors.ate.rmse, tools::Bound{.max = 0.05}, true},
                    {"tracked_fraction", 1, tools::Bound{.min = 1}, true},
                    {"keyframes", 300, {}, true}};
  report.options = {{"odometry.preset", "paper", "default", "where the options start from"},
                    {"odometry.tracker.pyramid.levels", "3", "3", "resolutions"}};
  for (std::size_t i = 100; i < 120; ++i) {
    report.frames[i].moving_fraction = 0.25;
  }
  for (std::size_t i = 110; i < 113; ++i) {
    report.frames[i].status = vo::TrackingStatus::uncertain;
    report.frames[i].reason = vo::TrackingReason::two_motions;
  }
  report.notes = {"a light of the scene was left out"};
  return report;
}

tools::ScenarioReport covered_lens() {
  tools::ScenarioReport report = support::plane_report(40, 30, {.max_bytes = 100'000});
  report.name = "covered <lens> & \"quotes\"</script>";
  report.metrics = {{"tracked_fraction", 0.75, tools::Bound{.min = 1}, false},
                    {"drift_percent", std::numeric_limits<double>::quiet_NaN(), {}, true}};
  return report;
}

tools::ScenarioReport monocular() {
  tools::ScenarioReport report = support::plane_report(12, 12);
  report.name = "monocular";
  report.alignment = vo::TrajectoryAlignment::sim3;
  report.times =
      std::vector<vo::StageTimes>(12, {.pyramid_ms = 1.5, .edges_ms = 2.25, .alignment_ms = 8});
  for (int i = 0; i < 12; ++i) {
    const vo::DepthImage truth = support::sway_frame(*report.camera, i).depth;
    vo::DepthImage estimate;
    truth.convertTo(estimate, CV_32F, 1.1);
    report.gallery.add_inverse_depth(report.truth.at(static_cast<std::size_t>(i)).timestamp,
                                     estimate, truth);
  }
  return report;
}

tools::ScenarioReport other_tracker() {
  tools::ScenarioReport report = support::plane_report(20, 20);
  report.name = "another tracker";
  report.tracker = "my_vo {sequence} {output}";
  report.camera.reset();
  report.gallery = tools::FrameGallery();
  return report;
}

tools::ScenarioReport crashed() {
  tools::ScenarioReport report;
  report.name = "crashed";
  report.why = "a tracker that crashes has failed";
  report.repeat = {.folder = "/home/user", .command = "edvo run crashed.toml --out crashed_again"};
  report.problem = "the tracker ended with signal 11";
  return report;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_example_report FILE.html\n";
    return 2;
  }
  vo::write_file(
      argv[1],
      tools::html_report({passed(), covered_lens(), monocular(), other_tracker(), crashed()}),
      vo::ExistingOutput::replace);
  return 0;
}
