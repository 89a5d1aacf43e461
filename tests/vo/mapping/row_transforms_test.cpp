#include <gtest/gtest.h>

#include "tests/support/plane_map.h"
#include "vo/mapping/lane_transform.h"
#include "vo/mapping/stereo_pair.h"

namespace {

using Eigen::Vector3d;
using vo::RowMotion;
using vo::SE3;

/// Moves a point between the cameras of a row and of the middle row, as RowMotion defines it:
/// `share` is 1 to the middle and -1 from it.
Vector3d rolled(const Vector3d& p, const RowMotion& motion, double share, double below) {
  return p +
         share * below * (motion.angular.cast<double>().cross(p) + motion.linear.cast<double>());
}

vo::FrameRelation hasty_relation() {
  vo::FrameRelation relation{
      SE3::exp((vo::Vector6d() << 0.1, -0.05, 0.02, 0.03, -0.02, 0.05).finished())};
  relation.host_motion.linear = {0.01F, 0.004F, -0.006F};
  relation.host_motion.angular = {0.01F, -0.02F, 0.015F};
  relation.current_motion.linear = {-0.008F, 0.006F, 0.003F};
  relation.current_motion.angular = {-0.02F, 0.01F, 0.02F};
  return relation;
}

TEST(RowTransforms, MovePointsFromTheHostsRowToTheCurrentRow) {
  const vo::FrameRelation relation = hasty_relation();
  const vo::RowTransforms rows(relation);
  ASSERT_TRUE(rows.is_rolling);
  for (const float host : {-0.5F, 0.0F, 0.3F}) {
    for (const float current : {-0.4F, 0.0F, 0.5F}) {
      const vo::RowTransforms::Matrix34f M = rows.of_middle + host * rows.by_host_row +
                                             current * (rows.by_current_row + host * rows.by_both);
      const Vector3d p(0.4, -0.3, 2);
      const Vector3d middle = relation.T_cur_host * rolled(p, relation.host_motion, 1, host);
      const Vector3d expected = rolled(middle, relation.current_motion, -1, current);
      EXPECT_LT((M.cast<double>() * p.homogeneous() - expected).norm(), 1e-6);
    }
  }
}

TEST(RowTransforms, AreThoseOfThePoseWithAGlobalShutter) {
  vo::FrameRelation relation = hasty_relation();
  relation.host_motion = relation.current_motion = {};
  const vo::RowTransforms rows(relation);
  EXPECT_FALSE(rows.is_rolling);
  EXPECT_TRUE(rows.of_middle.leftCols<3>() == relation.T_cur_host.rotation_matrix().cast<float>());
}

/// Each lane's transform must put its edge where the row that it was found at sees it.
TEST(LaneTransforms, AgreeWithTheRowThatSeesTheEdge) {
  const vo::PinholeCamera camera = support::small_camera();
  const vo::FramePyramid host =
      vo::build_pyramid(support::plane_frame(camera, SE3(), 0), camera, {});
  const vo::FrameRelation relation = hasty_relation();
  const vo::StereoPair pair(host.levels[0], host.levels[0], relation);
  vo::detail::Lanes<4> x{0.1F, -0.3F, 0.2F, 0};
  vo::detail::Lanes<4> y{0.2F, -0.2F, 0.1F, -0.3F};
  vo::detail::Lanes<4> d{0.5F, 0.7F, 0.3F, 1};
  vo::detail::LaneTransforms<4> transforms;
  vo::detail::set_transforms(pair, x, y, d, transforms);
  const auto below = [&](double slope) {
    return (camera.fy * slope + camera.cy + 0.5) / camera.height - 0.5;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d p = Vector3d(x[i], y[i], 1) / d[i];
    const Vector3d middle = relation.T_cur_host * rolled(p, relation.host_motion, 1, below(y[i]));
    const Vector3d unrolled = relation.T_cur_host * p;
    const Vector3d expected =
        rolled(middle, relation.current_motion, -1, below(unrolled.y() / unrolled.z()));
    for (std::size_t k = 0; k < 3; ++k) {
      const double moved = transforms.R[3 * k][i] * p.x() + transforms.R[3 * k + 1][i] * p.y() +
                           transforms.R[3 * k + 2][i] * p.z() + transforms.t[k][i];
      EXPECT_NEAR(moved, expected[static_cast<Eigen::Index>(k)], 1e-5);
    }
  }
}

}  // namespace
