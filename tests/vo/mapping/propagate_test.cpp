#include "vo/mapping/propagate.h"

#include <gtest/gtest.h>

#include "tests/support/plane_map.h"

namespace {

using support::small_camera;
using vo::SE3;

const SE3 kMoved = SE3::exp((vo::Vector6d() << 0.05, 0.03, 0.1, 0.02, -0.03, 0.05).finished());

vo::PyramidLevel level_from(const SE3& T_world_camera) {
  return support::grey_frame(small_camera(), T_world_camera).levels[0];
}

/// The plane's depth has a closed form wherever the point lands; float resolves 1e-7 of it.
TEST(Propagate, AKnownPlaneStaysThatPlane) {
  const vo::PyramidLevel host = level_from(SE3());
  const vo::PyramidLevel current = level_from(kMoved);
  const vo::StereoPair pair(host, current, {kMoved.inverse()});
  for (int v = 20; v < 240; v += 40) {
    for (int u = 20; u < 320; u += 40) {
      const double d = support::true_inverse_depth(small_camera(), SE3(), u, v);
      const Eigen::Vector3d ray = small_camera().unproject({u, v}, 1);
      const vo::MovedDepth moved =
          vo::moved_depth(pair, ray.head<2>().cast<float>(), static_cast<float>(d), 0, 0);
      const Eigen::Vector2d pixel = small_camera().project(moved.ray.cast<double>().homogeneous());
      const double truth =
          support::true_inverse_depth(small_camera(), kMoved, pixel.x(), pixel.y());
      EXPECT_NEAR(moved.inverse_depth / truth, 1, 2e-6) << u << ", " << v;
    }
  }
}

TEST(Propagate, MovesTheVarianceWithTheDerivative) {
  const vo::PyramidLevel host = level_from(SE3());
  const vo::PyramidLevel current = level_from(kMoved);
  const vo::StereoPair pair(host, current, {kMoved.inverse()});
  const Eigen::Vector2f ray(0.3F, -0.2F);
  const float step = 0.01F;
  const float slope = (vo::moved_depth(pair, ray, 0.5F + step, 0, 0).inverse_depth -
                       vo::moved_depth(pair, ray, 0.5F - step, 0, 0).inverse_depth) /
                      (2 * step);
  EXPECT_NEAR(vo::moved_depth(pair, ray, 0.5F, 0.04F, 0).variance, slope * slope * 0.04F, 1e-5);
}

/// A map of the true plane, moved: what snaps to an edge pixel has the depth of that pixel within
/// the slope of the plane over the snapping distance.
TEST(Propagate, SnapsToEdgesOfTheNewFrame) {
  const vo::PyramidLevel host = level_from(SE3());
  const vo::PyramidLevel current = level_from(kMoved);
  const vo::StereoPair pair(host, current, {kMoved.inverse()});
  vo::Hypotheses from = vo::edge_hypotheses(host, {}, 0.5F);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const cv::Vec2f edge = from.edge_position(i);
    from.set(
        i, static_cast<float>(support::true_inverse_depth(small_camera(), SE3(), edge[0], edge[1])),
        1e-6F);
  }
  vo::Hypotheses next = vo::edge_hypotheses(current, {}, 0.5F);
  const vo::PropagationCounts counts = vo::propagate(pair, from, next);
  EXPECT_GT(counts.moved, from.size() * 7 / 10);
  EXPECT_LT(counts.occluded, from.size() / 100);
  for (std::size_t j = 0; j < next.size(); ++j) {
    if (next.state[j] == vo::DepthState::known) {
      const double truth =
          support::true_inverse_depth(small_camera(), kMoved, next.pixel[j].x, next.pixel[j].y);
      EXPECT_NEAR(next.inverse_depth[j] / truth, 1, 3e-3);
    }
  }
}

/// Two hypotheses that meet: the nearer stays where they disagree, the mean where they agree.
TEST(Propagate, TheNearerOfTwoSurfacesHidesTheOther) {
  const vo::PyramidLevel level = level_from(SE3());
  const vo::StereoPair pair(level, level, {});
  vo::Hypotheses from = vo::edge_hypotheses(level, {}, 0.5F);
  ASSERT_GT(from.size(), 100U);
  const std::size_t i = 100;
  from.set(i, 0.4F, 1e-6F);
  vo::Hypotheses next = vo::edge_hypotheses(level, {}, 0.5F);
  next.set(i, 0.6F, 1e-6F);
  vo::propagate(pair, from, next);
  EXPECT_FLOAT_EQ(next.inverse_depth[i], 0.6F);
  next.set(i, 0.2F, 1e-6F);
  vo::propagate(pair, from, next);
  EXPECT_FLOAT_EQ(next.inverse_depth[i], 0.4F);
  next.set(i, 0.4002F, 1e-6F);
  vo::propagate(pair, from, next);
  EXPECT_GT(next.inverse_depth[i], 0.4F);
  EXPECT_LT(next.inverse_depth[i], 0.4002F);
}

}  // namespace
