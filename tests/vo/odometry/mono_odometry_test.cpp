#include "vo/odometry/mono_odometry.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/plane_frames.h"
#include "tests/support/pose_near.h"
#include "tests/support/sideways_walk.h"
#include "vo/core/fields.h"
#include "vo/evaluation/evaluate.h"
#include "vo/tracking/tracker.h"

namespace {

using support::sideways_walk;
using support::small_camera;
using vo::MonoBootstrap;
using vo::MonoState;
using vo::SE3;

struct TrackedWalk {
  vo::Trajectory truth;
  vo::Trajectory estimate;
  std::vector<vo::MonoResult> results;
};

/// Depth is handed over with the first frame only.
TrackedWalk tracked(const vo::MonoOptions& options, int frames) {
  vo::MonoOdometry odometry(small_camera(), options);
  TrackedWalk walked;
  for (int i = 0; i < frames; ++i) {
    vo::RgbdFrame frame = support::plane_frame(small_camera(), sideways_walk(i), i);
    if (i > 0) {
      frame.depth = vo::DepthImage();
    }
    walked.results.push_back(odometry.track(frame));
    walked.truth.push_back({frame.timestamp, sideways_walk(i)});
  }
  walked.estimate = odometry.trajectory();
  return walked;
}

vo::MonoOptions options_with(MonoBootstrap bootstrap) {
  vo::MonoOptions options = vo::mono_options();
  options.bootstrap = bootstrap;
  return options;
}

/// 0.25 % of a path of 0.4 m is 1 mm; a pixel is 7 mm wide on the plane.
class MonoWindow : public testing::TestWithParam<vo::WindowAdjustment> {};

TEST_P(MonoWindow, KeepsTheScaleOfADepthImage) {
  vo::MonoOptions options = options_with(MonoBootstrap::rgbd);
  options.tracker.window.adjust = GetParam();
  options.map.host.every = 3;
  const TrackedWalk done = tracked(options, 25);
  ASSERT_EQ(done.estimate.size(), 25U);
  const vo::TrajectoryErrors errors = vo::evaluate(done.truth, done.estimate);
  EXPECT_LT(errors.ate.rmse, 0.0025 * vo::path_length(done.truth));
}

INSTANTIATE_TEST_SUITE_P(MonoOdometry, MonoWindow,
                         testing::Values(vo::WindowAdjustment::none, vo::WindowAdjustment::poses,
                                         vo::WindowAdjustment::depth),
                         [](const auto& adjust) {
                           return std::string(vo::to_string(adjust.param));
                         });

TEST(MonoOdometry, FindsAnUnknownPlaneUpToScale) {
  const TrackedWalk done = tracked(options_with(MonoBootstrap::automatic), 60);
  ASSERT_EQ(done.estimate.size(), 60U);
  EXPECT_EQ(done.results.front().state, MonoState::initialising);
  EXPECT_EQ(done.results.back().state, MonoState::tracking);
  const vo::TrajectoryErrors errors =
      vo::evaluate(done.truth, done.estimate, {.alignment = vo::TrajectoryAlignment::sim3});
  EXPECT_LT(errors.ate.rmse, 0.01 * vo::path_length(done.truth));
}

TEST(MonoOdometry, DoesNotPretendWhileTheCameraOnlyTurns) {
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::automatic));
  for (int i = 0; i < 15; ++i) {
    const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0, 0.008 * i, 0).finished());
    const vo::MonoResult result = odometry.track(support::plane_frame(small_camera(), turn, i));
    EXPECT_EQ(result.state, MonoState::initialising);
  }
  EXPECT_FALSE(odometry.finish());
  EXPECT_TRUE(odometry.trajectory().empty());
}

/// A turn of so many frames, 0.03 rad each, then a walk.
SE3 turn_and_walk(int frame, int turning) {
  const double turned = 0.03 * std::min(frame, turning) - 0.5;
  const double walked = 0.03 * std::max(0, frame - turning);
  return SE3::exp((vo::Vector6d() << 0, 0, 0, 0, turned, 0).finished()) *
         SE3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(walked, 0.3 * walked, 0));
}

TEST(MonoOdometry, ATurnWithoutParallaxIsFollowedByItsRotation) {
  constexpr int kFrames = 40;
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::automatic));
  MonoState last = MonoState::initialising;
  for (int i = 0; i < kFrames; ++i) {
    last = odometry.track(support::plane_frame(small_camera(), turn_and_walk(i, kFrames), i)).state;
  }
  EXPECT_EQ(last, MonoState::orienting);
  const vo::Trajectory& estimate = odometry.trajectory();
  ASSERT_EQ(estimate.size(), std::size_t{kFrames});
  EXPECT_EQ(odometry.poses().count(MonoState::orienting), std::size_t{kFrames});
  for (int i = 0; i < kFrames; ++i) {
    const SE3 moved = estimate.front().T_world_camera.inverse() *
                      estimate[static_cast<std::size_t>(i)].T_world_camera;
    EXPECT_NEAR(moved.log().tail<3>().norm(), 0.03 * i, 0.0075) << "frame " << i;
  }
}

TEST(MonoOdometry, AStartReplacesTheRotationsOfItsFrames) {
  constexpr int kTurning = 22;  // then the first frame of the turn is out of view
  constexpr int kFrames = 50;
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::automatic));
  vo::Trajectory truth;
  std::vector<MonoState> states;
  for (int i = 0; i < kFrames; ++i) {
    const SE3 T_world_camera = turn_and_walk(i, kTurning);
    const vo::RgbdFrame frame = support::plane_frame(small_camera(), T_world_camera, i);
    states.push_back(odometry.track(frame).state);
    truth.push_back({frame.timestamp, T_world_camera});
  }
  EXPECT_EQ(states[kTurning], MonoState::orienting);
  EXPECT_EQ(states.back(), MonoState::tracking);
  ASSERT_EQ(odometry.trajectory().size(), std::size_t{kFrames});
  EXPECT_NEAR(static_cast<double>(odometry.poses().count(MonoState::orienting)), kTurning, 1);
  const auto walk = [](const vo::Trajectory& whole) {
    return vo::Trajectory(whole.begin() + kTurning + 1, whole.end());
  };
  const vo::TrajectoryErrors errors = vo::evaluate(walk(truth), walk(odometry.trajectory()),
                                                   {.alignment = vo::TrajectoryAlignment::sim3});
  EXPECT_LT(errors.ate.rmse, 0.02 * vo::path_length(walk(truth)));
}

TEST(MonoOdometry, TheEndOfASequenceMakesTheStartThatWaited) {
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::automatic));
  vo::Trajectory truth;
  double parallax_px = 0;
  for (int i = 0; i < support::kShortWalk; ++i) {
    const vo::RgbdFrame frame = support::plane_frame(small_camera(), sideways_walk(i), i);
    parallax_px = odometry.track(frame).initialiser.parallax_px;
    truth.push_back({frame.timestamp, sideways_walk(i)});
  }
  ASSERT_GT(parallax_px, 2);
  ASSERT_LT(parallax_px, 6);
  ASSERT_TRUE(odometry.trajectory().empty());
  const std::optional<vo::MonoResult> last = odometry.finish();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->state, MonoState::tracking);
  EXPECT_EQ(last->tracking.timestamp, truth.back().timestamp);
  ASSERT_EQ(odometry.trajectory().size(), truth.size());
  const vo::TrajectoryErrors errors =
      vo::evaluate(truth, odometry.trajectory(), {.alignment = vo::TrajectoryAlignment::sim3});
  EXPECT_LT(errors.ate.rmse, 0.02 * vo::path_length(truth));
  EXPECT_FALSE(odometry.finish());
}

TEST(MonoOdometry, TheEndOfASequenceChangesNothingWhileTracking) {
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::rgbd));
  vo::MonoOdometry undisturbed(small_camera(), options_with(MonoBootstrap::rgbd));
  EXPECT_FALSE(odometry.finish());
  for (int i = 0; i < 6; ++i) {
    const vo::RgbdFrame frame = support::plane_frame(small_camera(), sideways_walk(i), i);
    const SE3 T_world_camera = odometry.track(frame).tracking.T_world_camera;
    const SE3 T_world_undisturbed = undisturbed.track(frame).tracking.T_world_camera;
    EXPECT_EQ(T_world_camera.translation(), T_world_undisturbed.translation());
    EXPECT_EQ(T_world_camera.rotation_matrix(), T_world_undisturbed.rotation_matrix());
    EXPECT_FALSE(odometry.finish());
  }
}

TEST(MonoOdometry, ACutIsALossAndThenANewStart) {
  vo::MonoOptions options = options_with(MonoBootstrap::rgbd);
  options.max_lost_frames = 3;
  vo::MonoOdometry odometry(small_camera(), options);
  for (int i = 0; i < 5; ++i) {
    odometry.track(support::plane_frame(small_camera(), sideways_walk(i), i));
  }
  const SE3 elsewhere(Eigen::Quaterniond::Identity(), {40, 30, 0.3});
  MonoState last = MonoState::tracking;
  for (int i = 5; i < 9; ++i) {
    last =
        odometry.track(support::plane_frame(small_camera(), elsewhere * sideways_walk(i), i)).state;
  }
  EXPECT_EQ(last, MonoState::reinitialising);
}

/// A new map has the old one's median depth for its scale, which is a guess.
TEST(MonoOdometry, AMapAfterALossIsOfUncertainScale) {
  vo::MonoOptions options = options_with(MonoBootstrap::rgbd);
  options.max_lost_frames = 3;
  vo::MonoOdometry odometry(small_camera(), options);
  for (int i = 0; i < 5; ++i) {
    odometry.track(support::plane_frame(small_camera(), sideways_walk(i), i));
  }
  EXPECT_EQ(odometry.poses().count(MonoState::tracking), 5U);
  const SE3 elsewhere(Eigen::Quaterniond::Identity(), {7, 5, 0});
  vo::MonoResult last;
  for (int i = 5; i < 80; ++i) {
    last = odometry.track(support::plane_frame(small_camera(), elsewhere * sideways_walk(i), i));
  }
  EXPECT_EQ(last.state, MonoState::scale_uncertain);
  EXPECT_GT(last.scale.sigma, 0.4);
  EXPECT_EQ(odometry.poses().count(MonoState::tracking), 5U);
  EXPECT_GT(odometry.poses().count(MonoState::scale_uncertain), 20U);
}

/// Corners a third darker than the middle.
TEST(MonoOdometry, AVignetteIsFoundAndRemoved) {
  const vo::Vignette lens{{0.4, 0.1}};
  const auto error_with = [&](vo::VignetteModel model) {
    vo::MonoOptions options = options_with(MonoBootstrap::rgbd);
    options.tracker.vignette = model;
    vo::MonoOdometry odometry(small_camera(), options);
    vo::Trajectory truth;
    for (int i = 0; i < 40; ++i) {
      vo::RgbdFrame frame = support::plane_frame(small_camera(), sideways_walk(i), i);
      vo::GrayImage darkened;
      frame.image.convertTo(darkened, CV_32F);
      vo::take_out({}, small_camera(), lens, darkened);
      darkened.convertTo(frame.image, CV_8U);
      odometry.track(frame);
      truth.push_back({frame.timestamp, sideways_walk(i)});
    }
    const double found = odometry.tracker().vignette().gain({1, 1});
    EXPECT_NEAR(found, model == vo::VignetteModel::ignore ? 1 : lens.gain({1, 1}), 0.15);
    return vo::evaluate(truth, odometry.trajectory()).ate.rmse;
  };
  EXPECT_LT(2 * error_with(vo::VignetteModel::estimated), error_with(vo::VignetteModel::ignore));
}

TEST(MonoOdometry, WhatIsSeenAgainIsTheOldMap) {
  vo::MonoOptions options = options_with(MonoBootstrap::rgbd);
  options.max_lost_frames = 3;
  vo::MonoOdometry odometry(small_camera(), options);
  for (int i = 0; i < 20; ++i) {
    odometry.track(support::plane_frame(small_camera(), sideways_walk(i), i));
  }
  vo::RgbdFrame covered = support::plane_frame(small_camera(), SE3(), 0);
  covered.image = 0;
  for (int i = 20; i < 30; ++i) {
    covered.timestamp = support::plane_frame(small_camera(), SE3(), i).timestamp;
    EXPECT_EQ(odometry.track(covered).tracking.status, vo::TrackingStatus::lost);
  }
  for (int i = 30; i < 35; ++i) {
    const SE3 T_world_camera = sideways_walk(i - 20);
    const vo::MonoResult result =
        odometry.track(support::plane_frame(small_camera(), T_world_camera, i));
    EXPECT_EQ(result.state, MonoState::tracking) << "frame " << i;
    EXPECT_THAT(result.tracking.T_world_camera,
                support::PoseNear(T_world_camera, support::PoseTolerance{.translation_m = 0.002,
                                                                         .rotation_deg = 0.05}))
        << "frame " << i;
  }
}

/// A metric map is lost by a jump of 3 m, and the camera comes back in a new one, whose scale is a
/// guess: where they meet, the new map's poses become metric. The bound is a thousandth of the way.
TEST(MonoOdometry, ANewMapIsJoinedToTheLostOneWhereTheyMeet) {
  constexpr int kJump = 20;
  vo::MonoOptions options = options_with(MonoBootstrap::rgbd);
  options.max_lost_frames = 3;
  vo::MonoOdometry odometry(small_camera(), options);
  vo::Trajectory truth;
  int joined = 0;
  for (int i = 0; i < 110; ++i) {
    const double back = i < kJump ? 0 : 3 - 0.04 * (i - kJump);
    const SE3 T_world_camera = SE3(Eigen::Quaterniond::Identity(), Eigen::Vector3d(back, 0, 0)) *
                               sideways_walk(std::min(i, kJump));
    const vo::MonoResult result =
        odometry.track(support::plane_frame(small_camera(), T_world_camera, i));
    joined += result.joins_maps ? 1 : 0;
    truth.push_back({result.tracking.timestamp, T_world_camera});
  }
  EXPECT_EQ(joined, 1);
  EXPECT_EQ(odometry.poses().count(MonoState::scale_uncertain), 0U);
  EXPECT_GT(odometry.poses().size(), 100U);
  const vo::TrajectoryErrors errors =
      vo::evaluate(truth, odometry.trajectory(), {.alignment = vo::TrajectoryAlignment::se3});
  EXPECT_LT(errors.ate.rmse, 0.002);
}

TEST(MonoOdometry, WantsTheFirstDepthOnlyWhereItIsAskedFor) {
  vo::RgbdFrame frame = support::plane_frame(small_camera(), SE3(), 0);
  frame.depth = vo::DepthImage();
  vo::MonoOdometry needs(small_camera(), options_with(MonoBootstrap::rgbd));
  EXPECT_EQ(support::error_text([&] { needs.track(frame); }),
            "mono: expected the first frame's depth image with the camera's 320x240 px for the "
            "bootstrap, got 0x0 px");
  vo::MonoOdometry flat(small_camera(), options_with(MonoBootstrap::flat));
  EXPECT_EQ(flat.track(frame).state, MonoState::tracking);
}

TEST(MonoOdometry, WithoutParallaxItWaitsForIt) {
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::automatic));
  for (int i = 0; i < 15; ++i) {
    const vo::MonoResult result = odometry.track(support::plane_frame(small_camera(), SE3(), i));
    EXPECT_EQ(result.state, MonoState::initialising);
    EXPECT_EQ(result.tracking.status, vo::TrackingStatus::lost);
    EXPECT_EQ(result.initialiser.verdict, vo::InitialiserVerdict::waiting);
  }
  EXPECT_TRUE(odometry.trajectory().empty());
}

/// A tenth of a pixel is 0.7 mm on the plane.
TEST(MonoOdometry, WithKnownDepthsItFollowsACameraThatOnlyTurns) {
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::rgbd));
  for (int i = 0; i < 10; ++i) {
    const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0, 0.008 * i, 0).finished());
    const vo::MonoResult result = odometry.track(support::plane_frame(small_camera(), turn, i));
    EXPECT_EQ(result.state, MonoState::tracking);
    EXPECT_LT(result.tracking.T_world_camera.translation().norm(), 0.002);
  }
}

/// Depth is known at the left border alone, which leaves the view at once.
TEST(MonoOdometry, EdgesOfUnknownDepthTellATurn) {
  constexpr int kFrames = 40;
  constexpr double kTurn = 0.03;  // rad a frame
  vo::MonoOdometry odometry(small_camera(), options_with(MonoBootstrap::rgbd));
  for (int i = 0; i < kFrames; ++i) {
    const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0, kTurn * i - 0.6, 0).finished());
    vo::RgbdFrame frame = support::plane_frame(small_camera(), turn, i);
    frame.depth.colRange(60, frame.depth.cols) = 0;
    ASSERT_NE(odometry.track(frame).tracking.status, vo::TrackingStatus::lost) << "frame " << i;
  }
  const SE3 whole = odometry.trajectory().front().T_world_camera.inverse() *
                    odometry.trajectory().back().T_world_camera;
  EXPECT_NEAR(whole.log().tail<3>().norm(), kTurn * (kFrames - 1), 0.01);
}

/// From its own depth image: half the plane stands still, the other half moves with the camera.
TEST(MonoOdometry, WhenHalfTheImageMovesPosesAreFiniteOrLost) {
  for (const MonoBootstrap bootstrap :
       {MonoBootstrap::rgbd, MonoBootstrap::automatic, MonoBootstrap::random}) {
    vo::MonoOdometry odometry(small_camera(), options_with(bootstrap));
    for (int i = 0; i < 20; ++i) {
      vo::RgbdFrame frame = support::plane_frame(small_camera(), sideways_walk(i), i);
      const vo::RgbdFrame moving = support::plane_frame(small_camera(), sideways_walk(-2 * i), i);
      moving.image.colRange(0, 160).copyTo(frame.image.colRange(0, 160));
      const vo::MonoResult result = odometry.track(frame);
      const bool is_lost = result.tracking.status == vo::TrackingStatus::lost;
      EXPECT_EQ(is_lost, result.tracking.reason != vo::TrackingReason::none) << "frame " << i;
    }
    for (const vo::StampedPose& pose : odometry.trajectory()) {
      EXPECT_TRUE(pose.T_world_camera.translation().allFinite());
      EXPECT_LT(pose.T_world_camera.translation().norm(), 10);
    }
  }
}

TEST(MonoOdometry, AWallWithoutTextureIsNotTracked) {
  for (const MonoBootstrap bootstrap : {MonoBootstrap::rgbd, MonoBootstrap::automatic}) {
    vo::MonoOdometry odometry(small_camera(), options_with(bootstrap));
    for (int i = 0; i < 4; ++i) {
      const vo::MonoResult result = odometry.track(support::blank_frame(small_camera(), 128, i));
      EXPECT_EQ(result.tracking.status, vo::TrackingStatus::lost);
    }
    EXPECT_TRUE(odometry.trajectory().empty());
  }
}

}  // namespace
