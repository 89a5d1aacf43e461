#include "tools/report/trajectory_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/example_trajectory.h"
#include "tests/support/svg_document.h"
#include "vo/evaluation/evaluate.h"

namespace {

using support::svg_elements;
using support::svg_texts;
using support::SvgElement;
using testing::Contains;
using testing::EndsWith;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;
using vo::TrajectoryAlignment;

vo::Trajectory shifted(const vo::Trajectory& truth, double metres) {
  return support::moved({Eigen::Quaterniond::Identity(), {0, metres, 0}}, truth);
}

/// The colours of the estimate's pieces below the legend.
std::vector<std::string> strokes(const std::string& svg) {
  constexpr double kLegendEnd = 50;  // px
  std::vector<std::string> colours;
  for (const SvgElement& piece : svg_elements(svg, "line")) {
    if (piece.attributes.contains("stroke") && piece.place("x1", "y1").y() > kLegendEnd) {
      colours.push_back(piece.attributes.at("stroke"));
    }
  }
  return colours;
}

/// The greatest distance over time as it is drawn, m: the height of the lower panel's line above 0,
/// measured by the labels of its axis.
double greatest_distance(const std::string& svg) {
  constexpr double kHeight = 160;  // px, of the lower panel, where 0 is
  const SvgElement line = svg_elements(svg, "polyline").back();
  double top = kHeight;
  for (const Eigen::Vector2d& point : line.points()) {
    top = std::min(top, point.y() - line.origin.y());
  }
  std::vector<Eigen::Vector2d> labels;  // px above the panel's upper end, and value
  for (const SvgElement& text : svg_elements(svg, "text")) {
    const double above = line.origin.y() - text.origin.y();
    const auto anchor = text.attributes.find("text-anchor");
    if (above < 0 && anchor != text.attributes.end() && anchor->second == "end") {
      labels.emplace_back(above, std::stod(text.text));
    }
  }
  const Eigen::Vector2d span = labels.back() - labels.front();
  const std::vector<std::string> texts = svg_texts(svg);
  const bool is_in_mm =
      std::find(texts.begin(), texts.end(), "distance from the truth, mm") != texts.end();
  return (is_in_mm ? 0.001 : 1) * (kHeight - top) * span.y() / span.x();
}

TEST(TrajectoryPlot, DrawsASegmentPerPairOfPosesAndNamesTheLargestError) {
  const vo::Trajectory truth = support::example_trajectory(20, 30);
  const std::string svg =
      tools::draw_trajectory(truth, shifted(truth, 0.003), TrajectoryAlignment::none);
  EXPECT_THAT(strokes(svg),
              testing::AllOf(testing::SizeIs(truth.size() - 1), testing::Each("#fca636")))
      << "the largest error everywhere";
  EXPECT_THAT(svg_texts(svg), Contains("distance from the truth, mm").Times(2));
  EXPECT_THAT(svg_texts(svg), Contains("3")) << "of the colours, and of the errors over time";
}

TEST(TrajectoryPlot, DrawsBothWorldAxesInTheSameScale) {
  const vo::Trajectory truth = support::example_trajectory(200, 30);
  const std::string svg = tools::draw_trajectory(truth, truth, TrajectoryAlignment::none);
  EXPECT_THAT(svg_texts(svg), Contains("x, m"));
  EXPECT_THAT(svg_texts(svg), Contains("y, m"));
  Eigen::AlignedBox2d metres;
  for (const vo::StampedPose& pose : truth) {
    metres.extend(pose.T_world_camera.translation().head<2>());
  }
  Eigen::AlignedBox2d pixels;
  for (const SvgElement& drawn : svg_elements(svg, "polyline")) {
    if (drawn.points().size() == truth.size() && drawn.attributes.contains("stroke-opacity")) {
      for (const Eigen::Vector2d& point : drawn.points()) {
        pixels.extend(point);
      }
    }
  }
  const Eigen::Vector2d scale = pixels.sizes().cwiseQuotient(metres.sizes());
  EXPECT_GT(scale.x(), 100) << "px per m";
  EXPECT_NEAR(scale.y() / scale.x(), 1, 0.002);
}

TEST(TrajectoryPlot, SaysInWhichUnitAndPlaneAndWhetherAligned) {
  const vo::Trajectory truth = support::example_trajectory(20, 30);
  const vo::Trajectory estimate = shifted(truth, 3);
  const std::string svg = tools::draw_trajectory(truth, estimate, TrajectoryAlignment::none);
  EXPECT_THAT(svg_texts(svg), Contains("distance from the truth, m").Times(2));
  EXPECT_THAT(svg_texts(svg),
              Contains(MatchesRegex("Trajectory in the (x-y|y-z|z-x) plane of the truth's world; "
                                    "estimate not aligned")));
  EXPECT_THAT(svg_texts(tools::draw_trajectory(truth, estimate, TrajectoryAlignment::se3)),
              Contains(EndsWith("estimate aligned by SE(3), least squares")));
}

TEST(TrajectoryPlot, DrawsTheEstimateAsItIsJudged) {
  const vo::Trajectory truth = support::example_trajectory(20, 30);
  vo::Trajectory estimate = shifted(truth, 3);
  for (vo::StampedPose& pose : estimate) {
    pose.T_world_camera = {pose.T_world_camera.rotation(), 2 * pose.T_world_camera.translation()};
  }
  estimate[7].T_world_camera =
      estimate[7].T_world_camera * vo::SE3(Eigen::Quaterniond::Identity(), {0.05, 0, 0});
  for (const TrajectoryAlignment alignment :
       {TrajectoryAlignment::none, TrajectoryAlignment::se3, TrajectoryAlignment::sim3}) {
    const double greatest_m = vo::evaluate(truth, estimate, {.alignment = alignment}).ate.max;
    const std::string svg = tools::draw_trajectory(truth, estimate, alignment);
    EXPECT_NEAR(greatest_distance(svg), greatest_m, 0.01 * greatest_m) << vo::to_string(alignment);
  }
}

TEST(TrajectoryPlot, AnEstimateThatCannotBeAlignedIsDrawnAsItIs) {
  const vo::Trajectory truth = support::example_trajectory(20, 30);
  const vo::Trajectory estimate(truth.begin(), truth.begin() + 2);
  EXPECT_THAT(svg_texts(tools::draw_trajectory(truth, estimate, TrajectoryAlignment::se3)),
              Contains(EndsWith("estimate not aligned: fewer than three poses match")));
}

TEST(TrajectoryPlot, ShowsTheTruthDuringTheEstimateAndGreyWhereThereIsNone) {
  const vo::Trajectory truth = support::example_trajectory(64, 32);
  const vo::Trajectory estimate = support::example_trajectory(40, 32, 1);
  const std::string svg = tools::draw_trajectory(truth, estimate, TrajectoryAlignment::none);
  EXPECT_THAT(strokes(svg), Contains("#999999").Times(8)) << "the truth ends after 63/32 s";
  EXPECT_THAT(svg_texts(svg), Contains("estimate (grey: there is no truth)"));
  bool is_there = false;
  for (const SvgElement& drawn : svg_elements(svg, "polyline")) {
    is_there |= drawn.attributes.contains("stroke-opacity") && drawn.points().size() == 32;
  }
  EXPECT_TRUE(is_there) << "32 of 64 true poses are within the estimate's time";
}

TEST(TrajectoryPlot, WithoutTruthTheEstimateStandsAlone) {
  const std::string svg =
      tools::draw_trajectory({}, support::example_trajectory(20, 30), TrajectoryAlignment::none);
  EXPECT_EQ(svg_elements(svg, "polyline").back().points().size(), 20U);
  EXPECT_THAT(svg_texts(svg), Not(Contains(testing::HasSubstr("truth"))));
  EXPECT_THAT(svg_texts(svg), Not(Contains(StartsWith("time"))));
}

}  // namespace
