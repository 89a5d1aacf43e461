#include "vo/bootstrap/homography.h"

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"

namespace {

using support::hash_noise;
using vo::mixed_uniform;
using vo::RayPair;
using vo::SE3;

constexpr double kPixelsPerRay = 500;
constexpr double kRobustRay = 0.7 / kPixelsPerRay;
constexpr double kMinInFront = 0.9;

SE3 descent() {
  return SE3::exp((vo::Vector6d() << -0.1, 0.12, -0.25, 0.03, -0.02, 0.04).finished());
}

/// Places on a slanted plane, 1 to 3 away, off it by a share of their inverse depth; every twelfth
/// is followed wrongly.
std::vector<RayPair> plane_pairs(double relief, double noise_px, const SE3& T_second_first) {
  const Eigen::Vector3d inverse_depth_by_ray(0.1, 0.5, 0.6);
  std::vector<RayPair> pairs;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Eigen::Vector2d ray(mixed_uniform(3 * i + 1) - 0.5,
                              0.75 * (mixed_uniform(3 * i + 2) - 0.5));
    const double d =
        inverse_depth_by_ray.dot(ray.homogeneous()) * (1 + relief * (2 * mixed_uniform(3 * i) - 1));
    const Eigen::Vector3d p = T_second_first * Eigen::Vector3d(ray.homogeneous() / d);
    const Eigen::Vector2d noise(hash_noise(900 + 2 * i), hash_noise(901 + 2 * i));
    const Eigen::Vector2d wrong =
        i % 12 == 0 ? Eigen::Vector2d(0.02, -0.03) : Eigen::Vector2d(0, 0);
    pairs.push_back({ray, p.hnormalized() + noise_px / kPixelsPerRay * noise + wrong});
  }
  return pairs;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Returns the angle between the direction of the descent and the nearest of these motions'.
double nearest_direction(const std::vector<SE3>& motions) {
  double nearest = 10;
  for (const SE3& T : motions) {
    nearest = std::min(nearest, angle_between(T.translation(), descent().translation()));
  }
  return nearest;
}

TEST(Homography, IsThatOfThePlane) {
  const std::vector<RayPair> pairs = plane_pairs(0, 0, descent());
  const Eigen::Matrix3d H = vo::fit_homography(pairs, SE3());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i % 12 != 0) {
      const Eigen::Vector3d seen = H * pairs[i].first.homogeneous();
      EXPECT_LT((seen.hnormalized() - pairs[i].second).norm(), 1e-6) << i;
    }
  }
}

TEST(Homography, HasTheMotionAmongTwo) {
  const std::vector<RayPair> pairs = plane_pairs(0, 0, descent());
  const std::vector<SE3> motions =
      vo::motions_of_plane(pairs, vo::fit_homography(pairs, SE3()), kMinInFront);
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_LT(nearest_direction(motions), 1e-4);
  EXPECT_GT(angle_between(motions[0].translation(), motions[1].translation()), 0.3);
}

TEST(Homography, HasTheMotionAmongThoseOfNoisyPairs) {
  const std::vector<RayPair> pairs = plane_pairs(0, 0.2, descent());
  const auto motions = vo::motions_of_plane(pairs, vo::fit_homography(pairs, SE3()), kMinInFront);
  EXPECT_LT(nearest_direction(motions), 0.05);
}

/// Returns whether pairs off a plane by this share of their depth are taken for planar.
bool taken_for_planar(double relief, const SE3& T_second_first) {
  const std::vector<RayPair> pairs = plane_pairs(relief, 0.2, T_second_first);
  const SE3 turn = vo::fit_rotation(pairs).T_second_first;
  return vo::is_planar(pairs, vo::fit_homography(pairs, turn),
                       vo::fit_two_views(pairs, turn, kRobustRay), kRobustRay);
}

TEST(Homography, ExplainsAPlaneAndNothingElse) {
  EXPECT_TRUE(taken_for_planar(0, descent()));
  EXPECT_FALSE(taken_for_planar(0.1, descent()));
  EXPECT_FALSE(taken_for_planar(0.5, descent()));
}

TEST(Homography, OfATurnComesFromNoTranslation) {
  const SE3 turn = SE3::exp((vo::Vector6d() << 0, 0, 0, 0.05, -0.1, 0.03).finished());
  const std::vector<RayPair> pairs = plane_pairs(0, 0, turn);
  for (const SE3& T : vo::motions_of_plane(pairs, turn.rotation_matrix(), kMinInFront)) {
    ADD_FAILURE() << T.translation().transpose();
  }
}

}  // namespace
