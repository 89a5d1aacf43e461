#include "vo/sequence_odometry/track_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/plane_sequence.h"
#include "tests/support/temp_folder.h"

namespace {

using support::TempFolder;

TEST(TrackSequence, TracksEveryFrameAndTellsOfEach) {
  const TempFolder folder;
  const vo::Trajectory truth = support::write_plane_sequence(folder.path(), 5);
  const vo::SequenceReader sequence(folder.path());
  std::vector<std::size_t> done;
  int observed = 0;
  const vo::SequenceResult result = vo::track_sequence(
      sequence, {}, truth.front().T_world_camera,
      [&](const auto&, const auto&, const auto&, const auto&, const auto&) { ++observed; },
      [&](std::size_t count, std::size_t total) {
        EXPECT_EQ(total, 5U);
        done.push_back(count);
      });
  EXPECT_EQ(result.tracked_fraction(), 1);
  EXPECT_EQ(result.keyframes(), 5U);
  EXPECT_EQ(observed, 5);
  EXPECT_THAT(done, testing::ElementsAre(1, 2, 3, 4, 5));
}

TEST(TrackSequence, SummaryHasNearestRankPercentiles) {
  std::vector<vo::StageTimes> times;
  for (int i = 1; i <= 10; ++i) {
    times.push_back({.pyramid_ms = 1, .edges_ms = 2, .alignment_ms = 1.0 * i});
  }
  const vo::TimeSummary summary = vo::summarize(times);
  EXPECT_EQ(summary.median_ms, 3 + 5);
  EXPECT_EQ(summary.p90_ms, 3 + 9);
  EXPECT_EQ(summary.pyramid_ms, 1);
}

TEST(TrackSequence, FrameLogHasAColumnForEveryTitle) {
  vo::TrackingResult frame;
  const std::string log = vo::format_frame_log({frame, frame});
  const auto columns = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',') + 1;
  };
  std::istringstream lines(log);
  std::string header;
  std::string row;
  std::getline(lines, header);
  std::getline(lines, row);
  EXPECT_EQ(columns(header), 20 + 2 * 21) << "covariances: upper triangles of 6x6";
  EXPECT_EQ(columns(row), columns(header));
}

TEST(TrackSequence, FrameLogNamesTheFrameThatACovarianceRefersTo) {
  vo::TrackingResult first{.timestamp = 1, .status = vo::TrackingStatus::initialized};
  vo::TrackingResult frame{
      .timestamp = 2.5, .status = vo::TrackingStatus::tracked, .reference_timestamp = 1};
  frame.alignment.covariance(0, 0) = 0.25;
  frame.absolute_covariance(0, 0) = 0.75;
  const std::string log = vo::format_frame_log({first, frame});
  EXPECT_THAT(log, testing::HasSubstr(",reference_timestamp,covariance_tx_tx,covariance_tx_ty,"));
  EXPECT_THAT(log, testing::HasSubstr(",covariance_rz_rz,absolute_covariance_tx_tx,"));
  EXPECT_THAT(log, testing::HasSubstr(",1.000000,0.25,"));
  EXPECT_THAT(log, testing::HasSubstr(",0.75,"));
  EXPECT_THAT(log, testing::HasSubstr(",,0,")) << "the first frame has no reference";
}

TEST(TrackSequence, NoteTellsWhyFramesAreLostOrUncertainAndOfDepthsInAnotherUnit) {
  vo::SequenceResult result;
  result.frames.resize(4);
  result.frames[1].status = vo::TrackingStatus::uncertain;
  result.frames[1].reason = vo::TrackingReason::parts_disagree;
  result.frames[2] = result.frames[1];
  result.frames[3].reason = vo::TrackingReason::out_of_view;
  result.depths_m = {1.2F, 1.4F, 1.6F};
  EXPECT_EQ(result.uncertain(), 2U);
  EXPECT_EQ(vo::note_on(result), "lost or uncertain frames: out_of_view 1, parts_disagree 2");
  vo::SequenceResult near;
  near.depths_m = {0.24F, 0.28F, 0.3F};
  EXPECT_THAT(vo::note_on(near), testing::HasSubstr("the median depth is 0.28 m"));
  EXPECT_EQ(vo::note_on({}), "");
}

}  // namespace
