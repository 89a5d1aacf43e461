#include "vo/mapping/depth_map.h"

#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/plane_map.h"

namespace {

using support::grey_frame;
using support::median_magnitude;
using support::relative_errors;
using support::small_camera;
using vo::SE3;

/// 1 cm a frame past the plane at 2 m, turning a little.
SE3 walk(int frame) {
  return SE3::exp(
      (vo::Vector6d() << 0.01 * frame, 0.003 * frame, 0, 0, 0.001 * frame, 0).finished());
}

vo::DepthMap map_after(int frames, const vo::DepthMapOptions& options, int keyframe_interval) {
  vo::DepthMap map(options);
  map.start(grey_frame(small_camera(), walk(0)), 1);
  int host = 0;
  for (int i = 1; i <= frames; ++i) {
    const vo::FramePyramid current = grey_frame(small_camera(), walk(i));
    const vo::FrameRelation relation{walk(i).inverse() * walk(host)};
    map.observe(current, relation);
    map.regularise();
    if (i % keyframe_interval == 0) {
      map.propagate(current, relation);
      host = i;
    }
  }
  return map;
}

/// 0.67 x 0.15 px x z / (f b) with z = 2 m, f = 277 px, b = 0.2 m: 0.36 %.
TEST(DepthMap, FindsAnUnknownPlaneFromKnownPoses) {
  const vo::DepthMap map = map_after(20, {}, 100);
  const std::vector<double> errors = relative_errors(map, small_camera(), walk(0));
  ASSERT_GT(errors.size(), map.hypotheses().size() / 2);
  EXPECT_LT(median_magnitude(errors), 1.5 * 0.0036);
  const auto outliers = std::count_if(errors.begin(), errors.end(),
                                      [](double error) { return std::abs(error) > 0.1; });
  EXPECT_LT(static_cast<double>(outliers), 0.02 * static_cast<double>(errors.size()));
}

TEST(DepthMap, RescalingKeepsWhatIsRelative) {
  const vo::DepthMap before = map_after(10, {}, 100);
  vo::DepthMap after = before;
  after.rescale(2);
  EXPECT_EQ(after.confident(), before.confident());
  for (std::size_t i = 0; i < before.hypotheses().size(); ++i) {
    EXPECT_FLOAT_EQ(after.hypotheses().smoothed[i], before.hypotheses().smoothed[i] / 2);
    EXPECT_FLOAT_EQ(after.hypotheses().relative_sigma(i), before.hypotheses().relative_sigma(i));
  }
}

TEST(DepthMap, IsCarriedFromHostToHost) {
  const vo::DepthMap map = map_after(20, {}, 5);
  const std::vector<double> errors = relative_errors(map, small_camera(), walk(20));
  ASSERT_GT(errors.size(), map.hypotheses().size() / 2);
  EXPECT_LT(median_magnitude(errors), 1.5 * 0.0036);
}

/// A centimetre, the way from frame to frame, is 1.4 px of parallax; eight times as much is looked
/// back for.
TEST(DepthMap, LooksBackWhereEveryFrameBecomesAnHost) {
  const vo::DepthMap map = map_after(20, {.propagate = vo::PropagationPolicy::always}, 1);
  const std::vector<double> errors = relative_errors(map, small_camera(), walk(20));
  ASSERT_GT(errors.size(), map.hypotheses().size() / 2);
  EXPECT_LT(median_magnitude(errors), 1.5 * 0.0036);
  const vo::DepthMap forgetful = map_after(20, {}, 1);
  EXPECT_GT(map.confident(), forgetful.confident());
  EXPECT_LT(median_magnitude(errors),
            median_magnitude(relative_errors(forgetful, small_camera(), walk(20))));
}

TEST(DepthMap, GaussianBetaFusionFindsThePlaneToo) {
  const vo::DepthMap map = map_after(20, {.fusion = vo::Fusion::gaussian_beta}, 100);
  const std::vector<double> errors = relative_errors(map, small_camera(), walk(0));
  ASSERT_GT(errors.size(), map.hypotheses().size() / 2);
  EXPECT_LT(median_magnitude(errors), 1.5 * 0.0036);
}

TEST(DepthMap, PointsAreThoseOfTheDepthItWasGiven) {
  const vo::RgbdFrame frame = support::plane_frame(small_camera(), SE3(), 0);
  vo::DepthMap map({});
  map.start(grey_frame(small_camera(), SE3()), 1);
  map.take_depth(frame.depth, 0.01);
  const vo::EdgePoints points = map.points({});
  ASSERT_EQ(points.levels.size(), 3U);
  ASSERT_EQ(points.levels[0].size(), map.hypotheses().size());
  for (std::size_t i = 0; i < points.levels[0].size(); ++i) {
    const cv::Point pixel = points.levels[0].pixel[i];
    EXPECT_NEAR(points.levels[0].z_ref[i], frame.depth(pixel), 1e-5);
    EXPECT_NEAR(points.levels[0].depth_sigma[i], 0.01 * frame.depth(pixel), 1e-5);
  }
}

/// On every level, those of the depth image's own pyramid at the same pixels, in the same order. A
/// coarse pixel has a quarter of a degree of the plane's slope: depths differ by less than 1 %.
TEST(DepthMap, PointsAreWhatADepthSensorWouldGive) {
  const vo::PinholeCamera camera = support::small_camera();
  const vo::RgbdFrame frame = support::plane_frame(camera, SE3(), 0);
  vo::DepthMap map({});
  map.start(grey_frame(camera, SE3()), 1);
  map.take_depth(frame.depth, 0.01);
  vo::FramePyramid pyramid = vo::build_pyramid(frame, camera, vo::PyramidOptions());
  for (vo::PyramidLevel& level : pyramid.levels) {
    level.edges = vo::EdgeMask(level.intensity.size(), uchar{255});
  }
  const vo::EdgePoints expected = vo::edge_points(pyramid, pyramid, {});
  const vo::EdgePoints points = map.points({});
  for (std::size_t l = 0; l < points.levels.size(); ++l) {
    const vo::EdgePointLevel& level = points.levels[l];
    const vo::EdgePointLevel& all = expected.levels[l];
    ASSERT_GT(level.size(), 100U);
    std::size_t j = 0;
    for (std::size_t i = 0; i < level.size(); ++i) {
      while (j < all.size() && all.pixel[j] != level.pixel[i]) {
        ++j;
      }
      ASSERT_LT(j, all.size()) << "level " << l;
      EXPECT_EQ(level.intensity[i], all.intensity[j]);
      EXPECT_NEAR(level.z_ref[i], all.z_ref[j], 0.01 * all.z_ref[j]);
      EXPECT_NEAR(level.x_ref[i], all.x_ref[j], 0.01 * std::abs(all.x_ref[j]));
      EXPECT_NEAR(level.dI_dx[i], all.dI_dx[j], 0.01 * std::abs(all.dI_dx[j]));
      EXPECT_NEAR(level.dI_dz[i], all.dI_dz[j], 0.01 * std::abs(all.dI_dz[j]));
    }
  }
}

/// The near side's depth, and half the step between 1/2 and 1/3 as its standard deviation.
TEST(DepthMap, AtAStepOfTheDepthTheNearSideIsTakenForLessCertain) {
  constexpr int kStep = 160;  // px, first column of the far side
  vo::DepthImage depth(small_camera().height, small_camera().width, 3.0F);
  depth.colRange(0, kStep).setTo(2);
  vo::DepthMap map({});
  map.start(grey_frame(small_camera(), SE3()), 1);
  map.take_depth(depth, 0.01);
  std::size_t at_step = 0;
  for (std::size_t i = 0; i < map.hypotheses().size(); ++i) {
    const int u = map.hypotheses().pixel[i].x;
    const bool is_at_step = u == kStep - 1 || u == kStep;
    at_step += is_at_step ? 1 : 0;
    EXPECT_FLOAT_EQ(map.hypotheses().inverse_depth[i], u <= kStep ? 1 / 2.0F : 1 / 3.0F);
    EXPECT_NEAR(map.hypotheses().relative_sigma(i), is_at_step ? 0.5 * (1 - 2.0 / 3) : 0.01, 1e-6);
  }
  EXPECT_GT(at_step, 0U);
}

TEST(DepthMap, AStationaryCameraLeavesItAsItIs) {
  const vo::RgbdFrame frame = support::plane_frame(small_camera(), SE3(), 0);
  vo::DepthMap map({});
  const vo::FramePyramid host = grey_frame(small_camera(), SE3());
  map.start(host, 1);
  map.take_depth(frame.depth, 0.01);
  const std::vector<float> before = map.hypotheses().inverse_depth;
  const vo::ObservationCounts counts = map.observe(host, {});
  EXPECT_EQ(counts.unobservable, map.hypotheses().size());
  EXPECT_EQ(map.hypotheses().inverse_depth, before);
}

/// Half of the edges' depths are told to have grown by a tenth.
TEST(DepthMap, ACorrectionMovesTheOtherEdgesAlong) {
  vo::DepthMap map{vo::DepthMapOptions()};
  const vo::RgbdFrame frame = support::plane_frame(support::small_camera(), vo::SE3(), 0);
  map.start(support::grey_frame(support::small_camera(), vo::SE3()), 1);
  map.take_depth(frame.depth, 0.01);
  map.regularise();
  const vo::Hypotheses before = map.hypotheses();
  vo::EdgePointLevel points = map.points(vo::EdgePointOptions{.fraction = 0.5}).levels.front();
  ASSERT_LT(points.size(), before.size() * 2 / 3);
  std::vector<float> farther;
  for (const float z : points.z_ref) {
    farther.push_back(1.1F * z);
  }
  points.z_ref = farther;
  map.correct(points);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(before.smoothed[i] / map.hypotheses().smoothed[i], 1.1F, 1e-4F);
    EXPECT_EQ(before.variance[i], map.hypotheses().variance[i]);
  }
}

TEST(DepthMap, RefusesOptionsThatMakeNoSense) {
  EXPECT_EQ(support::error_text([] { vo::DepthMap map({.min_depth = 3, .max_depth = 2}); }),
            "depth_map: expected 0 < min_depth < max_depth, got 3 and 2");
}

}  // namespace
