#include "vo/image/edge_points.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"

namespace {

using support::small_camera;
using vo::EdgeSource;

vo::FramePyramid pyramid_at(const vo::SE3& T_world_camera) {
  vo::FramePyramid pyramid = vo::build_pyramid(
      support::TexturedPlane().render(small_camera(), T_world_camera), small_camera(), {});
  vo::add_edges(pyramid, {});
  return pyramid;
}

vo::SE3 moved_by(double x) {
  return {Eigen::Quaterniond::Identity(), {x, 0, 0}};
}

TEST(EdgePoints, LieOnTheSurfaceWhereTheMaskIs) {
  const vo::FramePyramid reference = pyramid_at({});
  const vo::EdgePoints points = vo::edge_points(reference, pyramid_at(moved_by(0.05)), {});
  const support::TexturedPlane plane;
  ASSERT_EQ(points.levels.size(), reference.levels.size());
  const vo::EdgePointLevel& finest = points.levels[0];
  ASSERT_EQ(finest.size(), static_cast<std::size_t>(cv::countNonZero(reference.levels[0].edges)));
  for (std::size_t i = 0; i < finest.size(); ++i) {
    const Eigen::Vector3d p_ref(finest.x_ref[i], finest.y_ref[i], finest.z_ref[i]);
    EXPECT_LT(std::abs(plane.normal.dot(p_ref - plane.point)), 1e-5);
    EXPECT_EQ(finest.intensity[i], reference.levels[0].intensity(finest.pixel[i]));
  }
}

TEST(EdgePoints, SourcesChooseWhoseEdges) {
  const vo::FramePyramid reference = pyramid_at({});
  const vo::FramePyramid current = pyramid_at(moved_by(0.05));
  const auto count = [&](EdgeSource source) {
    return vo::edge_points(reference, current, {.source = source}).levels[0].size();
  };
  EXPECT_EQ(count(EdgeSource::current),
            static_cast<std::size_t>(cv::countNonZero(current.levels[0].edges)));
  EXPECT_GT(count(EdgeSource::both), count(EdgeSource::current));
  EXPECT_LT(count(EdgeSource::both), count(EdgeSource::current) + count(EdgeSource::reference));
}

TEST(EdgePoints, PixelsWithoutDepthInRangeAreLeftOut) {
  const vo::FramePyramid reference = pyramid_at({});
  vo::FramePyramid holes = reference;
  for (vo::PyramidLevel& level : holes.levels) {
    level.depth = level.depth.clone();
    level.depth.setTo(0, level.edges);
  }
  EXPECT_EQ(vo::edge_points(holes, reference, {}).levels[0].size(), 0U);
  EXPECT_EQ(vo::edge_points(reference, reference, {.max_depth = 1}).levels[0].size(), 0U);
}

}  // namespace
