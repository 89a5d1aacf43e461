#include "vo/bootstrap/two_view.h"

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "tests/support/pose_near.h"

namespace {

using support::hash_noise;
using vo::mixed_uniform;
using vo::SE3;

constexpr double kFocalLength = 500;  // px
constexpr double kNoisePx = 0.2;

/// Places at depths of 1 to 4 seen before and after a motion, every tenth followed wrongly.
struct World {
  std::vector<vo::RayPair> pairs;
  std::vector<double> inverse_depth;
};

World world(const SE3& T_second_first, bool wrong_ones) {
  World world;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const double d = 0.25 + 0.75 * mixed_uniform(3 * i);
    const Eigen::Vector2d ray(mixed_uniform(3 * i + 1) - 0.5,
                              0.75 * (mixed_uniform(3 * i + 2) - 0.5));
    const Eigen::Vector3d p = T_second_first * Eigen::Vector3d(ray.homogeneous() / d);
    Eigen::Vector2d seen = p.hnormalized();
    seen +=
        kNoisePx / kFocalLength * Eigen::Vector2d(hash_noise(900 + 2 * i), hash_noise(901 + 2 * i));
    if (wrong_ones && i % 10 == 0) {
      seen += Eigen::Vector2d(0.02, -0.03);
    }
    world.pairs.push_back({ray, seen});
    world.inverse_depth.push_back(d);
  }
  return world;
}

std::vector<SE3> motions() {
  std::vector<SE3> motions;
  for (const Eigen::Vector3d& t :
       {Eigen::Vector3d(0.2, 0, 0), {0, 0, 0.3}, {0, 0, -0.3}, {-0.1, 0.1, 0.1}, {0, 0.2, 0.05}}) {
    vo::Vector6d xi;
    xi << t, 0.02, -0.06, 0.04;
    motions.push_back(SE3::exp(xi));
  }
  return motions;
}

TEST(TwoView, FindsMotionAndStructureFromScratch) {
  for (const SE3& T : motions()) {
    const World seen = world(T, true);
    const vo::RotationFit turn = vo::fit_rotation(seen.pairs);
    EXPECT_GT(turn.parallax * kFocalLength, 5);
    const vo::TwoViewFit fit =
        vo::fit_two_views(seen.pairs, turn.T_second_first, 0.7 / kFocalLength);
    const double length = T.translation().norm();
    const SE3 T_unit(T.rotation(), T.translation() / length);
    EXPECT_THAT(fit.T_second_first,
                support::PoseNear(
                    T_unit, support::PoseTolerance{.translation_m = 0.05, .rotation_deg = 0.25}))
        << T.translation().transpose();
    EXPECT_LT(fit.residual * kFocalLength, 1);
    EXPECT_GT(fit.in_front, 0.9);
  }
}

TEST(TwoView, ATurnHasNoParallax) {
  const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0.05, -0.1, 0.03).finished());
  const vo::RotationFit fit = vo::fit_rotation(world(turn, true).pairs);
  EXPECT_LT(fit.parallax * kFocalLength, 2 * kNoisePx);
  EXPECT_LT((fit.T_second_first.inverse() * turn).angle(), 1e-3);
}

TEST(TwoView, PlacesAFrameByKnownDepths) {
  for (const SE3& T : motions()) {
    const World seen = world(T, true);
    EXPECT_THAT(
        vo::fit_pose(seen.pairs, seen.inverse_depth, SE3(), 0.7 / kFocalLength),
        support::PoseNear(T, support::PoseTolerance{.translation_m = 0.002, .rotation_deg = 0.05}));
  }
}

TEST(TwoView, TriangulatesExactly) {
  const SE3 T = motions().front();
  const Eigen::Vector2d ray(0.1, -0.2);
  const Eigen::Vector3d p = T * Eigen::Vector3d(ray.homogeneous() / 0.4);
  EXPECT_NEAR(vo::triangulate({ray, p.hnormalized()}, T), 0.4, 1e-12);
}

}  // namespace
