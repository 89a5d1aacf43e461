#include "vo/tracking/window_adjustment.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/plane_view.h"
#include "tests/support/pose_near.h"
#include "vo/core/error.h"
#include "vo/core/instruction_set.h"

namespace {

using support::PoseNear;
using support::small_camera;
using vo::SE3;
using vo::Vector6d;
using vo::WindowAdjustment;

SE3 pose(double x, double y, double z, double a, double b, double c) {
  return SE3::exp((Vector6d() << x, y, z, a, b, c).finished());
}

/// Four views of the plane, the last one held.
class WindowAdjustmentTest : public testing::Test {
 protected:
  WindowAdjustmentTest() {
    for (const SE3& T_world_camera : T_world_) {
      pyramids_.push_back(support::plane_view(T_world_camera));
    }
    for (std::size_t f = 0; f < pyramids_.size(); ++f) {
      vo::EdgePoints points = vo::edge_points(pyramids_[f], pyramids_[f], {.max_points = 1500});
      frames_.push_back({.image = &pyramids_[f].levels.front(),
                         .points = points.levels.front(),
                         .measured_depth = points.levels.front().z_ref,
                         .T_frame_world = T_world_[f].inverse(),
                         .velocity = {},
                         .held = f + 1 == pyramids_.size()});
    }
  }

  void expect_true_poses(const support::PoseTolerance& tolerance) const {
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      EXPECT_THAT(frames_[f].T_frame_world.inverse(), PoseNear(T_world_[f], tolerance));
    }
  }

  /// As a sensor with this relative error would have measured.
  void disturb_depth(double relative_sigma) {
    std::mt19937 random(7);
    for (vo::WindowFrame& frame : frames_) {
      for (float& z : frame.measured_depth) {
        double sum = 0;  // of twelve uniform numbers: close to normal, the same on every machine
        for (int i = 0; i < 12; ++i) {
          sum += static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
        }
        z *= static_cast<float>(1 + relative_sigma * (sum - 6));
      }
      frame.points = vo::at_depths(frame.points, frame.measured_depth);
      for (std::size_t i = 0; i < frame.points.size(); ++i) {
        frame.points.depth_sigma[i] = static_cast<float>(relative_sigma) * frame.points.z_ref[i];
      }
    }
  }

  /// Relative, of the points' depths.
  double rms_depth_error() const {
    double sum = 0;
    double count = 0;
    for (std::size_t f = 0; f < frames_.size(); ++f) {
      const vo::EdgePointLevel& points = frames_[f].points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double z = support::TexturedPlane().depth(
            small_camera(), T_world_[f], Eigen::Vector2d(points.pixel[i].x, points.pixel[i].y));
        const double error = points.z_ref[i] / z - 1;
        sum += error * error;
        count += 1;
      }
    }
    return std::sqrt(sum / count);
  }

  std::vector<SE3> T_world_{SE3(), pose(0.12, 0.02, 0.01, 0.01, -0.04, 0.01),
                            pose(-0.03, 0.13, 0.03, -0.05, 0.01, 0.02),
                            pose(0.1, 0.1, -0.05, -0.03, -0.03, -0.02)};
  std::vector<vo::FramePyramid> pyramids_;
  std::vector<vo::WindowFrame> frames_;
  vo::AlignOptions align_{.formulation = vo::Formulation::esm,
                          .loss = vo::RobustLoss::student_t,
                          .scale = vo::LossScale::residuals,
                          .brightness = vo::BrightnessModel::affine};
};

TEST_F(WindowAdjustmentTest, BringsDisturbedPosesBack) {
  frames_[0].T_frame_world = pose(0.003, -0.002, 0.002, 1e-3, 2e-3, -1e-3);
  frames_[2].T_frame_world = pose(-0.002, 0.003, 0.001, -2e-3, 0, 1e-3) * T_world_[2].inverse();
  vo::adjust_window(frames_, {.adjust = WindowAdjustment::poses, .max_iterations = 10}, align_);
  expect_true_poses({.translation_m = 2e-4, .rotation_deg = 5e-3});
}

TEST_F(WindowAdjustmentTest, LeavesHeldPosesAndDepthAsTheyAre) {
  const SE3 T_held = pose(0.001, 0, 0, 0, 0, 1e-3) * frames_[3].T_frame_world;
  frames_[3].T_frame_world = T_held;
  const std::vector<float> depth = frames_[0].points.z_ref;
  vo::adjust_window(frames_, {.adjust = WindowAdjustment::poses}, align_);
  EXPECT_THAT(frames_[3].T_frame_world, PoseNear(T_held, support::PoseTolerance{1e-15, 1e-12}));
  EXPECT_EQ(frames_[0].points.z_ref, depth);
}

TEST_F(WindowAdjustmentTest, FindsDepthThatWasMeasuredBadly) {
  disturb_depth(0.02);
  const double measured = rms_depth_error();
  ASSERT_NEAR(measured, 0.02, 0.001);
  vo::adjust_window(frames_, {.adjust = WindowAdjustment::depth, .max_iterations = 10}, align_);
  EXPECT_LT(rms_depth_error(), measured / 2);
  expect_true_poses({.translation_m = 4e-3, .rotation_deg = 0.1});  // points were 40 mm off
}

/// The firmer the sensor's depth, the less it is moved.
TEST_F(WindowAdjustmentTest, BelievesTheSensorAsItIsTold) {
  disturb_depth(0.02);
  const double measured = rms_depth_error();
  vo::adjust_window(frames_, {.adjust = WindowAdjustment::depth, .depth_noise = 1e-3}, align_);
  EXPECT_NEAR(rms_depth_error(), measured, 1e-4);
}

TEST_F(WindowAdjustmentTest, AllowsForABrightnessOfEachPair) {
  vo::PyramidLevel& level = pyramids_[1].levels.front();
  level.intensity = 0.7 * level.intensity + 0.1;
  vo::EdgePoints points = vo::edge_points(pyramids_[1], pyramids_[1], {.max_points = 1500});
  frames_[1].points = points.levels.front();
  frames_[1].measured_depth = frames_[1].points.z_ref;
  frames_[1].T_frame_world = pose(-0.002, 0.003, 0.001, -2e-3, 0, 1e-3) * T_world_[1].inverse();
  vo::adjust_window(frames_, {.adjust = WindowAdjustment::poses, .max_iterations = 10}, align_);
  expect_true_poses({.translation_m = 3e-4, .rotation_deg = 8e-3});
}

TEST_F(WindowAdjustmentTest, DoesNothingWhereNoFrameSeesAnother) {
  frames_.resize(2);
  frames_[1].held = true;
  frames_[1].T_frame_world = pose(0, 0, 0, 0, 3, 0);
  vo::adjust_window(frames_, {.adjust = WindowAdjustment::depth}, align_);
  EXPECT_THAT(frames_[0].T_frame_world, PoseNear(SE3(), support::PoseTolerance{1e-12, 1e-9}));
}

/// Points at other depths are what the level shows there.
TEST_F(WindowAdjustmentTest, MovesPointsAlongTheirRays) {
  const vo::EdgePointLevel& points = frames_[1].points;
  std::vector<float> depth;
  std::vector<vo::PixelDepth> pixels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    depth.push_back(points.z_ref[i] * (0.9F + 0.2F * static_cast<float>(i % 7) / 6));
    pixels.push_back({points.pixel[i], depth.back(), 0.01F});
  }
  const vo::EdgePointLevel moved = vo::at_depths(points, depth);
  vo::EdgePointLevel expected;
  vo::show_points(pyramids_[1].levels.front(), pixels, vo::InstructionSet::baseline, expected);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(moved.z_ref[i], expected.z_ref[i]);
    EXPECT_NEAR(moved.x_ref[i], expected.x_ref[i], 1e-6);
    EXPECT_NEAR(moved.y_ref[i], expected.y_ref[i], 1e-6);
    EXPECT_NEAR(moved.dI_dx[i], expected.dI_dx[i], 1e-4);
    EXPECT_NEAR(moved.dI_dy[i], expected.dI_dy[i], 1e-4);
    EXPECT_NEAR(moved.dI_dz[i], expected.dI_dz[i], 1e-4);
  }
}

TEST(WindowOptions, OutOfRangeAreErrors) {
  EXPECT_THROW(vo::WindowOptions{.moved = 0}.validate(), vo::Error);
  EXPECT_THROW(vo::WindowOptions{.held = 0}.validate(), vo::Error);
  EXPECT_THROW(vo::WindowOptions{.max_iterations = 0}.validate(), vo::Error);
  EXPECT_THROW(vo::WindowOptions{.min_overlap = 1.1}.validate(), vo::Error);
  EXPECT_THROW(vo::WindowOptions{.depth_noise = 0}.validate(), vo::Error);
}

}  // namespace
