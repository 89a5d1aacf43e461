#include "vo/image/edge_points.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/core/error.h"

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

TEST(EdgePoints, AreAsUncertainAsTheDepthCameraIs) {
  const vo::FramePyramid reference = pyramid_at({});
  const vo::DepthNoise stereo{.constant = 3e-4, .quadratic = 4e-3};
  for (const auto& [given, expected] :
       {std::pair{stereo, stereo}, std::pair{vo::DepthNoise{}, vo::kStructuredLightNoise}}) {
    const vo::EdgePointLevel points =
        vo::edge_points(reference, reference, {.depth_noise = given}).levels[0];
    ASSERT_GT(points.size(), 0U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(points.depth_sigma[i], expected.sigma(points.z_ref[i]), 1e-8);
    }
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

std::size_t points_of(const vo::FramePyramid& reference, const vo::EdgePointOptions& options) {
  return vo::edge_points(reference, reference, options).levels[0].size();
}

TEST(EdgePoints, RandomPixelsAreAsManyAsEdgePixelsWithDepth) {
  vo::FramePyramid reference = pyramid_at({});
  reference.levels[0].depth = reference.levels[0].depth.clone();
  reference.levels[0].depth(cv::Rect(0, 0, 100, 240)).setTo(0);
  const auto random =
      vo::edge_points(reference, reference, {.selection = vo::PointSelection::random, .seed = 3});
  EXPECT_EQ(random.levels[0].size(), points_of(reference, {}));
  EXPECT_TRUE(vo::has_edge_pixels_with_depth(reference.levels[0], points_of(reference, {}), {}));
  EXPECT_FALSE(
      vo::has_edge_pixels_with_depth(reference.levels[0], points_of(reference, {}) + 1, {}));
  std::size_t on_edges = 0;
  for (const cv::Point& pixel : random.levels[0].pixel) {
    EXPECT_GE(pixel.x, 100);
    on_edges += reference.levels[0].edges(pixel) != 0 ? 1 : 0;
  }
  const double share = static_cast<double>(points_of(reference, {})) / (220 * 240);
  EXPECT_NEAR(static_cast<double>(on_edges), share * static_cast<double>(random.levels[0].size()),
              0.5 * share * static_cast<double>(random.levels[0].size()))
      << "edge pixels by chance";
}

TEST(EdgePoints, AllPixelsAreDense) {
  EXPECT_EQ(points_of(pyramid_at({}), {.selection = vo::PointSelection::all}), 320U * 240U);
}

/// A count of independent draws spreads by the root of n p (1 - p); five of those.
TEST(EdgePoints, FractionAndMaxPointsThinOut) {
  const vo::FramePyramid reference = pyramid_at({});
  const auto all = static_cast<double>(points_of(reference, {}));
  for (const double fraction : {0.1, 0.5}) {
    EXPECT_NEAR(static_cast<double>(points_of(reference, {.fraction = fraction})), all * fraction,
                5 * std::sqrt(all * fraction * (1 - fraction)));
  }
  EXPECT_NEAR(static_cast<double>(points_of(reference, {.max_points = 400})), 400, 5 * 20);
  EXPECT_EQ(points_of(reference, {.max_points = 1000000}), points_of(reference, {}));
}

TEST(EdgePoints, AThinnedSetIsASubsetThatTheSeedChooses) {
  const vo::FramePyramid reference = pyramid_at({});
  const auto thinned = [&](std::uint64_t seed) {
    return vo::edge_points(reference, reference, {.fraction = 0.3, .seed = seed}).levels[0];
  };
  const vo::EdgePointLevel points = thinned(1);
  EXPECT_EQ(points.pixel, thinned(1).pixel);
  EXPECT_NE(points.pixel, thinned(2).pixel);
  const vo::PyramidLevel& level = reference.levels[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NE(level.edges(points.pixel[i]), 0);
    EXPECT_EQ(points.intensity[i], level.intensity(points.pixel[i]));
    EXPECT_EQ(points.z_ref[i], level.depth(points.pixel[i]));
  }
}

TEST(EdgePoints, CoarserLevelsHaveTheirShareOfTheLimit) {
  const vo::EdgePointOptions options{
      .max_points = 1000, .coarser_share = 0.7, .discontinuity_radius = 4};
  EXPECT_EQ(options.at_level(0).max_points, 1000);
  EXPECT_EQ(options.at_level(2).max_points, 490);
  EXPECT_EQ(options.at_level(2).discontinuity_radius, 1);
  EXPECT_EQ(vo::EdgePointOptions().at_level(3).max_points, 0) << "no limit";
}

/// Depth steps from 2 to 3 m between columns 159 and 160: within r px lie 2 r columns.
TEST(EdgePoints, PointsNearADepthStepAreLeftOut) {
  vo::FramePyramid reference = pyramid_at({});
  vo::DepthImage step(240, 320, 2.0F);
  step.colRange(160, 320).setTo(3);
  step(100, 20) = 0;  // a hole is no step
  reference.levels[0].depth = step;
  for (const int radius : {1, 2, 5}) {
    const vo::EdgePoints points =
        vo::edge_points(reference, reference,
                        {.selection = vo::PointSelection::all, .discontinuity_radius = radius});
    EXPECT_EQ(points.levels[0].size(), 240U * (320U - 2U * static_cast<unsigned>(radius)) - 1U);
    for (const cv::Point& pixel : points.levels[0].pixel) {
      EXPECT_TRUE(pixel.x < 160 - radius || pixel.x >= 160 + radius) << pixel.x;
    }
  }
  EXPECT_EQ(vo::edge_points(reference, reference,
                            {.selection = vo::PointSelection::all,
                             .discontinuity_radius = 2,
                             .discontinuity_ratio = 1.6})
                .levels[0]
                .size(),
            320U * 240U - 1U)
      << "a step of 1.5 is none";
}

/// A smooth image over the pixels of a lens with distortion.
double smooth_intensity(const vo::PinholeCamera& camera, const Eigen::Vector3d& p_camera) {
  const Eigen::Vector2d pixel = camera.project(p_camera);
  return 0.5 + 0.2 * std::sin(0.03 * pixel.x() + 0.01 * pixel.y()) +
         0.1 * std::cos(0.02 * pixel.y());
}

/// Central differences over 2 px miss (0.03 px)^2 / 6 of a slope of 0.03 rad/px.
TEST(EdgePoints, DerivativesAreThoseOfTheImageByThePointsPosition) {
  vo::PinholeCamera camera = small_camera();
  camera.distortion = {.k1 = 0.2, .k2 = -0.3, .p1 = -0.005, .p2 = 0.003};
  vo::FramePyramid reference =
      vo::build_pyramid(support::TexturedPlane().render(camera, vo::SE3()), camera, {.levels = 1});
  vo::PyramidLevel& level = reference.levels[0];
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      level.intensity(v, u) =
          static_cast<float>(smooth_intensity(camera, camera.unproject({u, v}, 1)));
    }
  }
  level.edges = vo::EdgeMask(240, 320, uchar{0});
  level.edges(cv::Rect(10, 10, 300, 220)).setTo(255);
  const vo::EdgePointLevel points =
      vo::edge_points(reference, reference, {.fraction = 0.02}).levels[0];
  constexpr double kStep = 1e-5;  // m
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p_ref(points.x_ref[i], points.y_ref[i], points.z_ref[i]);
    const Eigen::Vector3d found(points.dI_dx[i], points.dI_dy[i], points.dI_dz[i]);
    Eigen::Vector3d expected;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
      expected(axis) =
          (smooth_intensity(camera, p_ref + step) - smooth_intensity(camera, p_ref - step)) /
          (2 * kStep);
    }
    EXPECT_LT((found - expected).norm(), 2e-4 * camera.fx * 0.008 + 1e-3 * expected.norm()) << i;
  }
  EXPECT_GT(points.size(), 1000U);
}

TEST(EdgePoints, HaveTheSameBitsWithEveryInstructionSet) {
  for (const vo::DistortionModel model :
       {vo::DistortionModel::brown_conrady, vo::DistortionModel::kannala_brandt}) {
    vo::PinholeCamera camera = small_camera();
    camera.distortion = {.k1 = 0.1, .k2 = -0.05, .model = model};
    const vo::FramePyramid frame = vo::build_pyramid(
        support::TexturedPlane().render(camera, vo::SE3()), camera, {.levels = 1});
    std::vector<vo::PixelDepth> pixels;
    for (int i = 0; i < 100; ++i) {
      pixels.push_back({{3 * i, 2 * i}, 1 + 0.01F * static_cast<float>(i), 0.02F});
    }
    const vo::InstructionSet best = vo::available_instruction_set();
    vo::EdgePointLevel one;
    vo::EdgePointLevel other;
    vo::show_points(frame.levels[0], pixels, best, one);
    vo::show_points(frame.levels[0], pixels, vo::InstructionSet::baseline, other);
    EXPECT_EQ(one.x_ref, other.x_ref);
    EXPECT_EQ(one.y_ref, other.y_ref);
    EXPECT_EQ(one.dI_dx, other.dI_dx);
    EXPECT_EQ(one.dI_dy, other.dI_dy);
    EXPECT_EQ(one.dI_dz, other.dI_dz);
  }
}

TEST(EdgePoints, OfTheNextFrameAreFoundInTheSameMemory) {
  const vo::PinholeCamera camera = small_camera();
  vo::FramePyramid frame =
      vo::build_pyramid(support::TexturedPlane().render(camera, vo::SE3()), camera, {.levels = 2});
  vo::add_edges(frame, vo::EdgeOptions{});
  const vo::EdgePointOptions options{.max_points = 500};
  vo::EdgePointFinder finder(options);
  vo::EdgePoints points;
  finder.find(frame, frame, points);
  const float* memory = points.levels[0].x_ref.data();
  points.levels[0].x_ref[0] = -1;
  finder.find(frame, frame, points);
  EXPECT_EQ(points.levels[0].x_ref.data(), memory);
  EXPECT_EQ(points.levels[0].x_ref, vo::edge_points(frame, frame, options).levels[0].x_ref);
}

TEST(EdgePoints, OptionsOutOfRangeAreErrors) {
  EXPECT_THROW(vo::EdgePointOptions{.fraction = 0}.validate(), vo::Error);
  EXPECT_THROW(vo::EdgePointOptions{.max_points = -1}.validate(), vo::Error);
  EXPECT_THROW((vo::EdgePointOptions{.min_depth = 2, .max_depth = 1}.validate()), vo::Error);
  EXPECT_THROW(vo::EdgePointOptions{.discontinuity_radius = 11}.validate(), vo::Error);
  EXPECT_THROW(vo::EdgePointOptions{.discontinuity_ratio = 1}.validate(), vo::Error);
}

}  // namespace
