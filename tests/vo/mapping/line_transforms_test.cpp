#include <gtest/gtest.h>

#include "tests/support/plane_map.h"
#include "vo/mapping/lane_transform.h"
#include "vo/mapping/stereo_pair.h"

namespace {

using Eigen::Vector3d;
using vo::ReadoutAxis;
using vo::ReadoutMotion;
using vo::SE3;

/// Moves a point between the cameras of a line and of the middle line, as ReadoutMotion defines it:
/// `share` is 1 to the middle and -1 from it.
Vector3d rolled(const Vector3d& p, const ReadoutMotion& motion, double share, double past) {
  return p + share * past * (motion.angular.cast<double>().cross(p) + motion.linear.cast<double>());
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

TEST(LineTransforms, MovePointsFromTheHostsLineToTheCurrentLine) {
  const vo::FrameRelation relation = hasty_relation();
  const vo::LineTransforms lines(relation);
  ASSERT_TRUE(lines.is_rolling);
  for (const float host : {-0.5F, 0.0F, 0.3F}) {
    for (const float current : {-0.4F, 0.0F, 0.5F}) {
      const vo::LineTransforms::Matrix34f M =
          lines.of_middle + host * lines.by_host_line +
          current * (lines.by_current_line + host * lines.by_both);
      const Vector3d p(0.4, -0.3, 2);
      const Vector3d middle = relation.T_cur_host * rolled(p, relation.host_motion, 1, host);
      const Vector3d expected = rolled(middle, relation.current_motion, -1, current);
      EXPECT_LT((M.cast<double>() * p.homogeneous() - expected).norm(), 1e-6);
    }
  }
}

TEST(LineTransforms, AreThoseOfThePoseWithAGlobalShutter) {
  vo::FrameRelation relation = hasty_relation();
  relation.host_motion = relation.current_motion = {};
  const vo::LineTransforms lines(relation);
  EXPECT_FALSE(lines.is_rolling);
  EXPECT_TRUE(lines.of_middle.leftCols<3>() == relation.T_cur_host.rotation_matrix().cast<float>());
}

/// Each lane's transform must put its edge where the line that it was found at sees it.
void expect_lanes_agree(ReadoutAxis axis) {
  const vo::PinholeCamera camera = support::small_camera();
  const vo::FramePyramid host =
      vo::build_pyramid(support::plane_frame(camera, SE3(), 0), camera, {});
  vo::FrameRelation relation = hasty_relation();
  relation.host_motion.axis = relation.current_motion.axis = axis;
  const vo::StereoPair pair(host.levels[0], host.levels[0], relation);
  vo::detail::Lanes<4> x{0.1F, -0.3F, 0.2F, 0};
  vo::detail::Lanes<4> y{0.2F, -0.2F, 0.1F, -0.3F};
  vo::detail::Lanes<4> d{0.5F, 0.7F, 0.3F, 1};
  vo::detail::LaneTransforms<4> transforms;
  vo::detail::set_transforms(pair, x, y, d, transforms);
  const auto past = [&](const Vector3d& p) {
    return axis == ReadoutAxis::rows
               ? (camera.fy * p.y() / p.z() + camera.cy + 0.5) / camera.height - 0.5
               : (camera.fx * p.x() / p.z() + camera.cx + 0.5) / camera.width - 0.5;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d p = Vector3d(x[i], y[i], 1) / d[i];
    const Vector3d middle = relation.T_cur_host * rolled(p, relation.host_motion, 1, past(p));
    const Vector3d expected =
        rolled(middle, relation.current_motion, -1, past(relation.T_cur_host * p));
    for (std::size_t k = 0; k < 3; ++k) {
      const double moved = transforms.R[3 * k][i] * p.x() + transforms.R[3 * k + 1][i] * p.y() +
                           transforms.R[3 * k + 2][i] * p.z() + transforms.t[k][i];
      EXPECT_NEAR(moved, expected[static_cast<Eigen::Index>(k)], 1e-5);
    }
  }
}

TEST(LaneTransforms, AgreeWithTheLineThatSeesTheEdge) {
  expect_lanes_agree(ReadoutAxis::rows);
  expect_lanes_agree(ReadoutAxis::columns);
}

}  // namespace
