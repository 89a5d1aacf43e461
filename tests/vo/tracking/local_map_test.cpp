#include "vo/tracking/local_map.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/core/error.h"
#include "vo/tracking/image_motion.h"

namespace {

using support::small_camera;
using vo::SE3;

constexpr double kDepth = 2;      // m, of every point
constexpr double kFlowPx = 1e-3;  // px, what single precision leaves of a displacement

SE3 moved_by(double x) {
  return {Eigen::Quaterniond::Identity(), {x, 0, 0}};
}

SE3 turned_by(double angle, const Eigen::Vector3d& axis) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)), {0, 0, 0}};
}

/// A frame of which nothing but the cameras is known: two levels, the coarser with half the pixels.
vo::FramePyramid cameras_only() {
  vo::FramePyramid pyramid;
  for (const vo::CameraLevel& level : vo::camera_levels(small_camera(), {.levels = 2})) {
    pyramid.levels.push_back({level.camera, {}, {}, {}, {}});
  }
  return pyramid;
}

/// Points of a wall that faces the camera: pixels of the coarser level, 160x120.
vo::EdgePoints wall_points(const std::vector<cv::Point>& pixels) {
  const vo::PinholeCamera camera = small_camera().halved();
  vo::EdgePoints points;
  points.levels.resize(2);
  for (const cv::Point& pixel : pixels) {
    const Eigen::Vector3d p_ref = camera.unproject({pixel.x, pixel.y}, kDepth);
    points.levels[1].x_ref.push_back(static_cast<float>(p_ref.x()));
    points.levels[1].y_ref.push_back(static_cast<float>(p_ref.y()));
    points.levels[1].z_ref.push_back(static_cast<float>(p_ref.z()));
    points.levels[1].pixel.push_back(pixel);
  }
  return points;
}

std::vector<cv::Point> every_pixel() {
  std::vector<cv::Point> pixels;
  for (int v = 0; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) {
      pixels.emplace_back(u, v);
    }
  }
  return pixels;
}

/// All points move by fx t / z; the columns that leave the image are no longer seen.
TEST(ImageMotion, OfATranslationBesideAWall) {
  const double fx = small_camera().fx;
  for (const int columns : {0, 1, 16, 40}) {
    const double flow_px = 2 * columns;  // of the finest level
    const vo::ImageMotion motion = vo::image_motion(wall_points(every_pixel()), cameras_only(),
                                                    moved_by(flow_px * kDepth / fx));
    EXPECT_NEAR(motion.flow_px, flow_px, kFlowPx);
    EXPECT_NEAR(motion.overlap, 1 - columns / 160.0, 1e-9);
  }
}

/// A point at r px from the principal point moves by 2 r sin(angle / 2).
TEST(ImageMotion, OfARotationAboutTheOpticalAxis) {
  const std::vector<cv::Point> pixels{{110, 60}, {40, 80}, {79, 20}};
  const vo::PinholeCamera camera = small_camera().halved();
  const double angle = 0.3;
  double mean_px = 0;
  for (const cv::Point& pixel : pixels) {
    const double radius_px = 2 * std::hypot(pixel.x - camera.cx, pixel.y - camera.cy);
    mean_px += 2 * radius_px * std::sin(angle / 2) / static_cast<double>(pixels.size());
  }
  const vo::ImageMotion motion =
      vo::image_motion(wall_points(pixels), cameras_only(), turned_by(angle, {0, 0, 1}));
  EXPECT_NEAR(motion.flow_px, mean_px, kFlowPx);
  EXPECT_EQ(motion.overlap, 1);
}

TEST(ImageMotion, HalfATurnSeesNothing) {
  const vo::ImageMotion motion = vo::image_motion(wall_points(every_pixel()), cameras_only(),
                                                  turned_by(std::numbers::pi, {0, 1, 0}));
  EXPECT_EQ(motion.overlap, 0);
  EXPECT_EQ(motion.flow_px, 0);
}

TEST(ImageMotion, OfNoPointsIsNone) {
  EXPECT_EQ(vo::image_motion(wall_points({}), cameras_only(), SE3()).overlap, 0);
}

vo::LocalMap map_of(const vo::MapOptions& options, const std::vector<double>& positions) {
  vo::LocalMap map(options);
  for (const double x : positions) {
    map.add({cameras_only(), std::make_shared<const vo::EdgePoints>(wall_points(every_pixel())),
             moved_by(x)});
  }
  return map;
}

std::vector<double> positions_of(const vo::LocalMap::References& frames) {
  std::vector<double> positions;
  positions.reserve(frames.size());
  for (const auto& frame : frames) {
    positions.push_back(frame->T_world_keyframe.translation().x());
  }
  return positions;
}

TEST(LocalMap, TheNearestViewComesFirst) {
  const vo::LocalMap map = map_of({.references = 3}, {0, 0.1, 0.2, 0.3});
  EXPECT_EQ(positions_of(map.references_for(moved_by(0.22))), (std::vector{0.2, 0.3, 0.1}));
  EXPECT_EQ(positions_of(map.references_for(moved_by(-5))), (std::vector{0.3}))
      << "the last where none is in view";
}

/// A wall 2 m away is 2.3 m wide in view: a keyframe 1.5 m off shares a third of it.
TEST(LocalMap, AViewWithLittleInCommonIsNoReference) {
  const vo::LocalMap map = map_of({.references = 3, .min_overlap = 0.5}, {0, 0.2, 1.5});
  EXPECT_EQ(positions_of(map.references_for(moved_by(0))), (std::vector{0.0, 0.2}));
}

TEST(LocalMap, WithOneReferenceItIsTheLast) {
  const vo::LocalMap map = map_of({.references = 1}, {0, 0.1, 0.2});
  EXPECT_EQ(positions_of(map.references_for(moved_by(0))), (std::vector{0.2}));
}

TEST(LocalMap, AWindowIsTheLastKeyframeAndThoseAroundIt) {
  const vo::LocalMap map = map_of({.min_overlap = 0.5}, {0, 0.3, 1.5, 0.4, 0.1});
  EXPECT_EQ(map.around_last(3), (std::vector<std::size_t>{4, 0, 1}));
  EXPECT_EQ(map.around_last(9), (std::vector<std::size_t>{4, 0, 1, 3})) << "2 is out of view";
  EXPECT_EQ(map.around_last(1), (std::vector<std::size_t>{4}));
}

TEST(LocalMap, AnAdjustedKeyframeIsWhereItWasFound) {
  vo::LocalMap map = map_of({}, {0, 0.1, 0.2});
  vo::EdgePointLevel finest;
  finest.z_ref = {7};
  const std::shared_ptr<const vo::Keyframe> before = map.keyframes()[1];
  map.adjust(1, moved_by(0.11), finest);
  EXPECT_EQ(map.keyframes()[1]->T_world_keyframe.translation().x(), 0.11);
  EXPECT_EQ(map.keyframes()[1]->points->levels.front().z_ref, finest.z_ref);
  EXPECT_TRUE(before->points->levels.front().z_ref.empty()) << "whoever holds it sees no change";
}

/// A keyframe with a finest point in the middle of every tile, 8x8 px, whose depth was measured.
vo::Keyframe keyframe_of_tiles() {
  vo::EdgePoints points;
  points.levels.resize(2);
  vo::EdgePointLevel& finest = points.levels.front();
  finest.resize(vo::ViewTiles::kCount);
  for (std::size_t tile = 0; tile < vo::ViewTiles::kCount; ++tile) {
    const auto index = static_cast<int>(tile);
    finest.pixel[tile] = {8 * (index % vo::ViewTiles::kColumns) + 4,
                          8 * (index / vo::ViewTiles::kColumns) + 4};
    finest.z_ref[tile] = static_cast<float>(1 + index);
  }
  vo::Keyframe keyframe{cameras_only(), std::make_shared<const vo::EdgePoints>(points), SE3()};
  keyframe.measured_depth = finest.z_ref;
  return keyframe;
}

vo::LocalMap map_of_tiles() {
  vo::LocalMap map{vo::MapOptions{}};
  map.add(keyframe_of_tiles());
  map.add(keyframe_of_tiles());
  return map;
}

vo::TileMask columns(std::size_t first, std::size_t count) {
  vo::TileMask tiles;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    const std::size_t column = tile % vo::ViewTiles::kColumns;
    tiles[tile] = column >= first && column < first + count;
  }
  return tiles;
}

/// Each column of tiles is 2.5 % of the view.
TEST(LocalMap, LeavesOutOfAKeyframeWhatMovedAndIsDisturbedByMuchOfIt) {
  vo::LocalMap map = map_of_tiles();
  const std::shared_ptr<const vo::Keyframe> before = map.keyframes().front();
  map.leave_out(*before, columns(0, 4));
  const std::shared_ptr<const vo::Keyframe> once = map.keyframes().front();
  EXPECT_EQ(once->points->levels.front().size(), 1200U * 36 / 40);
  EXPECT_EQ(once->measured_depth, once->points->levels.front().z_ref);
  EXPECT_EQ(once->measured_depth.front(), 5) << "the fifth column";
  EXPECT_FALSE(once->is_disturbed()) << "10 %";

  map.leave_out(*once, columns(3, 2));
  const vo::Keyframe& twice = *map.keyframes().front();
  EXPECT_EQ(twice.points->levels.front().size(), 1200U * 35 / 40);
  EXPECT_EQ(twice.moved, columns(0, 5));
  EXPECT_TRUE(twice.is_disturbed()) << "12.5 %, what moved before included";
}

TEST(LocalMap, LeavesNothingOutOfOtherKeyframes) {
  vo::LocalMap map = map_of_tiles();
  const std::shared_ptr<const vo::Keyframe> replaced = map.keyframes().front();
  map.leave_out(*replaced, columns(0, 10));
  EXPECT_EQ(replaced->points->levels.front().size(), 1200U) << "whoever holds it sees no change";
  EXPECT_EQ(map.keyframes().back()->points->levels.front().size(), 1200U);
  map.leave_out(*replaced, columns(0, 40));
  EXPECT_EQ(map.keyframes().front()->points->levels.front().size(), 1200U * 30 / 40)
      << "it is no longer in the map";
}

TEST(LocalMap, ForgetsTheOldest) {
  const vo::LocalMap map = map_of({.references = 2, .max_keyframes = 2}, {0, 0.1, 0.2});
  ASSERT_EQ(map.keyframes().size(), 2U);
  EXPECT_EQ(positions_of(map.references_for(moved_by(0))), (std::vector{0.1, 0.2}));
}

TEST(LocalMap, AVelocityThatIsKnownLaterIsTheLastKeyframes) {
  vo::LocalMap map = map_of({.references = 2}, {0, 0.1});
  EXPECT_FALSE(map.last()->velocity.has_value());
  const vo::Vector6d velocity = vo::Vector6d::Constant(0.3);
  map.set_last_velocity({velocity, vo::Vector6d::Zero()});
  ASSERT_TRUE(map.last()->velocity.has_value());
  EXPECT_EQ(map.last()->velocity->twist, velocity);
  EXPECT_FALSE(map.keyframes().front()->velocity.has_value());
  EXPECT_EQ(positions_of(map.references_for(moved_by(0.1))), (std::vector{0.1, 0.0}));
}

/// At 0.1 m/s a wall 2 m away moves by 13.9 px/s; 20 ms are 0.28 px, 40 ms from 20 to -20 are 0.55.
TEST(LocalMap, ForgetsKeyframesThatAnotherReadOutBends) {
  const auto map_at = [](double speed) {
    vo::LocalMap map({.references = 2});
    vo::Keyframe keyframe{cameras_only(),
                          std::make_shared<const vo::EdgePoints>(wall_points(every_pixel())),
                          moved_by(0)};
    keyframe.velocity.emplace();
    keyframe.velocity->twist[0] = speed;
    keyframe.readout = {.seconds = 0.02};
    map.add(keyframe);
    map.add(keyframe);
    return map;
  };
  const auto left = [&](double speed, const vo::Readout& readout) {
    vo::LocalMap map = map_at(speed);
    map.forget_bent(readout);
    return map.keyframes().size();
  };
  EXPECT_EQ(left(0.1, {.seconds = 0.04}), 2U);
  EXPECT_EQ(left(0.1, {.seconds = -0.02}), 1U) << "the last one stays";
  EXPECT_EQ(left(0.1, {0.04, vo::ReadoutAxis::columns}), 1U) << "45 ms in all";
  EXPECT_EQ(left(0, {.seconds = -0.02}), 2U) << "at rest nothing bends";
}

/// Per point eight floats and a pixel; per pixel two floats and an edge byte.
TEST(LocalMap, MemoryIsThatOfPointsAndImages) {
  vo::FramePyramid frame = cameras_only();
  frame.levels[1].intensity.create(120, 160);
  frame.levels[1].depth.create(120, 160);
  frame.levels[1].edges.create(120, 160);
  vo::LocalMap map{vo::MapOptions{}};
  EXPECT_EQ(map.memory_bytes(), 0U);
  const auto points = std::make_shared<const vo::EdgePoints>(wall_points({{1, 1}, {5, 7}}));
  map.add({frame, points, SE3()});
  map.add({frame, points, SE3()});
  EXPECT_EQ(map.memory_bytes(), 2U * (2 * (8 * 4 + 8) + 120 * 160 * 9));
}

TEST(LocalMap, OptionsOutOfRangeAreErrors) {
  EXPECT_THROW(vo::MapOptions{.references = 0}.validate(), vo::Error);
  EXPECT_THROW((vo::MapOptions{.references = 3, .max_keyframes = 2}.validate()), vo::Error);
  EXPECT_THROW(vo::MapOptions{.min_overlap = 1.1}.validate(), vo::Error);
}

}  // namespace
