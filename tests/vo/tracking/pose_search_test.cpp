#include "vo/tracking/pose_search.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/pose_near.h"
#include "tests/support/textured_plane.h"

namespace {

using support::PoseNear;
using support::small_camera;
using vo::SE3;

constexpr support::PoseTolerance kSame{1e-12, 1e-9};

SE3 moved_sideways_by(double x) {
  return {Eigen::Quaterniond::Identity(), {x, 0, 0}};
}

SE3 turned_by(const Eigen::Vector3d& rotation_deg) {
  vo::Vector6d turn = vo::Vector6d::Zero();
  turn.tail<3>() = rotation_deg * std::numbers::pi / 180;
  return SE3::exp(turn);
}

vo::FramePyramid frame_at(const SE3& T_world_camera) {
  vo::FramePyramid pyramid =
      vo::build_pyramid(support::TexturedPlane().render(small_camera(), T_world_camera),
                        small_camera(), {.levels = 4});
  vo::add_edges(pyramid, {});
  return pyramid;
}

vo::Keyframe keyframe_at(const SE3& T_world_camera) {
  vo::FramePyramid frame = frame_at(T_world_camera);
  auto points = std::make_shared<const vo::EdgePoints>(vo::edge_points(frame, frame, {}));
  return {std::move(frame), std::move(points), T_world_camera};
}

TEST(PoseSearch, AFrameAgreesWithItself) {
  const vo::Keyframe keyframe = keyframe_at(moved_sideways_by(0.3));
  EXPECT_NEAR(vo::coarse_agreement(keyframe, keyframe.pyramid, moved_sideways_by(0.3)), 1, 1e-6);
  EXPECT_LT(vo::coarse_agreement(keyframe, keyframe.pyramid, moved_sideways_by(0.4)), 0.9);
  EXPECT_EQ(vo::coarse_agreement(keyframe, keyframe.pyramid, moved_sideways_by(5)), -1)
      << "out of view";
}

TEST(PoseSearch, TheTruthIsTheBestGuess) {
  const vo::Keyframe keyframe = keyframe_at(SE3());
  const SE3 truth = turned_by({3, -5, 2});
  const SE3 best = vo::best_guess(keyframe, frame_at(truth),
                                  {SE3(), moved_sideways_by(0.05), truth, moved_sideways_by(9)});
  EXPECT_THAT(best, PoseNear(truth, kSame));
}

TEST(PoseSearch, BetterGuessesComeFirst) {
  const vo::Keyframe keyframe = keyframe_at(SE3());
  const std::vector<SE3> best = vo::best_guesses(keyframe, keyframe.pyramid,
                                                 {moved_sideways_by(9), moved_sideways_by(0.02),
                                                  moved_sideways_by(0), moved_sideways_by(0.01)},
                                                 3);
  ASSERT_EQ(best.size(), 3U);
  for (const int rank : {0, 1, 2}) {
    EXPECT_THAT(best[static_cast<std::size_t>(rank)],
                PoseNear(moved_sideways_by(0.01 * rank), kSame));
  }
}

TEST(PoseSearch, OfGuessesThatAreAllOutOfViewTheFirstIsTaken) {
  const vo::Keyframe keyframe = keyframe_at(SE3());
  const SE3 best =
      vo::best_guess(keyframe, keyframe.pyramid, {moved_sideways_by(9), moved_sideways_by(8)});
  EXPECT_THAT(best, PoseNear(moved_sideways_by(9), kSame));
}

/// Guesses lie on a grid of 4 deg: at most half the diagonal of its cells away, 3.5 deg.
TEST(PoseSearch, EveryTurnOfUpTo12DegreesHasAGuessNearby) {
  const SE3 from = moved_sideways_by(0.7) * turned_by({10, 20, 30});
  const std::vector<SE3> guesses = vo::turned_guesses(from);
  EXPECT_THAT(guesses.front(), PoseNear(from, kSame));
  for (int i = 0; i < 500; ++i) {
    const double height = 1 - (i + 0.5) / 250;  // a spiral over the sphere
    const double longitude = 2.4 * i;
    const double ring = std::sqrt(1 - height * height);
    const Eigen::Vector3d axis(ring * std::cos(longitude), ring * std::sin(longitude), height);
    const SE3 truth = from * turned_by((1 + i % 12) * axis);
    double nearest = std::numbers::pi;
    for (const SE3& guess : guesses) {
      EXPECT_EQ(guess.translation(), from.translation());
      nearest = std::min(nearest, (guess.inverse() * truth).angle());
    }
    EXPECT_LT(nearest * 180 / std::numbers::pi, 3.5);
  }
}

TEST(PoseSearch, TheMostSimilarKeyframeComesFirst) {
  vo::LocalMap map({.references = 1});
  for (const double x : {0.0, 0.5, 1.0}) {
    map.add(keyframe_at(moved_sideways_by(x)));
  }
  const std::vector<SE3> poses = vo::similar_keyframes(map, frame_at(moved_sideways_by(0.51)), 2);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_THAT(poses.front(), PoseNear(moved_sideways_by(0.5), kSame));
  EXPECT_EQ(vo::similar_keyframes(map, frame_at(SE3()), 9).size(), 3U);
}

}  // namespace
