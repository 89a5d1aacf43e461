#include "vo/residuals/point_pass.h"

#include <gtest/gtest.h>

#include "tests/support/instruction_sets.h"
#include "tests/support/textured_plane.h"
#include "tests/support/warp_oracle.h"
#include "vo/dataset/camera_file.h"

namespace {

using vo::InstructionSet;
using vo::SE3;
using vo::Vector6d;

/// Two views of the plane through a lens with distortion, and the points of the first.
struct Scene {
  vo::PinholeCamera camera = vo::load_camera("tum-fr1").pinhole;
  SE3 T_cur_ref = SE3::exp((Vector6d() << 0.02, -0.01, 0.03, 0.01, 0.02, -0.015).finished());
  vo::FramePyramid reference = pyramid(SE3());
  vo::FramePyramid current = pyramid(T_cur_ref.inverse());
  vo::EdgePoints points = vo::edge_points(reference, reference, {});

  vo::FramePyramid pyramid(const SE3& T_world_camera) const {
    vo::FramePyramid result = vo::build_pyramid(
        support::TexturedPlane().render(camera, T_world_camera), camera, {.levels = 1});
    vo::add_edges(result, {});
    return result;
  }

  vo::PointView view() const {
    vo::PointView result{points.levels[0], current.levels[0], T_cur_ref, {}, {}};
    result.points_motion.angular = {0.01F, -0.02F, 0.005F};
    result.image_motion.linear = {0.01F, 0.002F, -0.01F};
    return result;
  }
};

TEST(PointPass, EveryInstructionSetGivesTheSameBits) {
  const Scene scene;
  for (const vo::RobustLoss loss : {vo::RobustLoss::none, vo::RobustLoss::huber,
                                    vo::RobustLoss::tukey, vo::RobustLoss::student_t}) {
    const vo::PassOptions options{.loss = loss,
                                  .loss_scale = 0.02F,
                                  .gain = 1.1F,
                                  .current_share = 0.5F,
                                  .reference_share = 0.5F,
                                  .inverse_variance = 1000,
                                  .max_depth_ratio = 1.1F,
                                  .brightness = true};
    const vo::PointEquations expected =
        vo::sum_points(scene.view(), options, InstructionSet::baseline);
    ASSERT_GT(expected.points, 1000U);
    for (const InstructionSet set : support::instruction_sets_of_this_machine()) {
      const vo::PointEquations sums = vo::sum_points(scene.view(), options, set);
      EXPECT_EQ(sums.H, expected.H);
      EXPECT_EQ(sums.b, expected.b);
      EXPECT_EQ(sums.cost, expected.cost);
      EXPECT_EQ(sums.points, expected.points);
    }
  }
}

/// The same sums written down point by point in double precision.
TEST(PointPass, SumsWhatThePaperSays) {
  const Scene scene;
  const vo::EdgePointLevel& points = scene.points.levels[0];
  const vo::GrayImage& image = scene.current.levels[0].intensity;
  const vo::Warp<double> warp(scene.camera, scene.T_cur_ref);
  vo::Matrix6d H = vo::Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto point =
        vo::warp_point<double>(warp, {points.x_ref[i], points.y_ref[i], points.z_ref[i]});
    if (point.u < 1 || point.v < 1 || point.u >= image.cols - 2 || point.v >= image.rows - 2) {
      continue;
    }
    const support::BilinearWeights at(static_cast<float>(point.u), static_cast<float>(point.v));
    cv::Vec2f gradient;
    for (const auto& [du, dv, weight] :
         {std::tuple{0, 0, at.w00}, {1, 0, at.w10}, {0, 1, at.w01}, {1, 1, at.w11}}) {
      gradient += weight * vo::central_gradient(image, {at.u + du, at.v + dv});
    }
    const Vector6d J = support::forward_jacobian<double>(point, gradient[0], gradient[1]);
    H += J * J.transpose();
    b += J * static_cast<double>(at(image) - points.intensity[i]);
  }
  const vo::PointEquations sums =
      vo::sum_points({points, scene.current.levels[0], scene.T_cur_ref, {}, {}},
                     {.loss = vo::RobustLoss::none}, vo::available_instruction_set());
  for (int p = 0; p < 6; ++p) {
    for (int q = 0; q < 6; ++q) {
      EXPECT_NEAR(sums.H(p, q), H(p, q), 1e-4 * std::sqrt(H(p, p) * H(q, q))) << p << " " << q;
    }
    EXPECT_NEAR(sums.b(p), b(p), 1e-4 * std::sqrt(H(p, p))) << p;
  }
}

}  // namespace
