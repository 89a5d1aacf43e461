#include <array>

#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>

#include "tests/cross/image_function.h"
#include "tests/support/plane_view.h"
#include "tests/support/pose_near.h"
#include "vo/alignment/align.h"

namespace {

using support::ImageFunction;
using support::interior;
using support::plane_view;
using support::PoseNear;
using vo::SE3;
using vo::Vector6d;

/// The photometric residual of one point as a function of an increment [translation; rotation
/// vector] left of a fixed pose: written apart from the tracker's warp and Jacobian.
struct PhotometricResidual {
  ImageFunction image;
  vo::PinholeCamera camera;
  Eigen::Vector3d p_start;  ///< the point under the fixed pose, m
  double intensity;

  template <typename T>
  bool operator()(const T* translation, const T* rotation, T* residual) const {
    const T start[3] = {T(p_start.x()), T(p_start.y()), T(p_start.z())};
    T p[3];
    ceres::AngleAxisRotatePoint(rotation, start, p);
    for (int i = 0; i < 3; ++i) {
      p[i] += translation[i];
    }
    residual[0] =
        image(p[0] / p[2] * camera.fx + camera.cx, p[1] / p[2] * camera.fy + camera.cy) - intensity;
    return true;
  }
};

SE3 solve_with_ceres(const vo::EdgePointLevel& points, const vo::PyramidLevel& level,
                     const SE3& T_start, double loss_scale) {
  ceres::Problem problem;
  std::array<double, 3> translation{};
  std::array<double, 3> rotation{};
  const ImageFunction image(level);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p_ref(points.x_ref[i], points.y_ref[i], points.z_ref[i]);
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PhotometricResidual, 1, 3, 3>(
            new PhotometricResidual{image, level.camera, T_start * p_ref, points.intensity[i]}),
        new ceres::HuberLoss(loss_scale), translation.data(), rotation.data());
  }
  ceres::Solver::Options options;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  Vector6d rotation_only = Vector6d::Zero();
  rotation_only.tail<3>() = Eigen::Vector3d(rotation.data());
  return SE3(SE3::exp(rotation_only).rotation(), Eigen::Vector3d(translation.data())) * T_start;
}

TEST(Align, FindsWhatCeresFinds) {
  Vector6d xi;
  xi << 0.004, -0.003, 0.005, 0.002, 0.003, -0.004;
  const SE3 T_world_cur = SE3::exp(xi);
  const vo::FramePyramid reference = plane_view(SE3());
  const vo::FramePyramid current = plane_view(T_world_cur);
  vo::EdgePoints points = vo::edge_points(reference, current, {});
  constexpr int kBorder = 40;  // px; no point leaves the view: both objectives sum over the same
  points.levels[0] = interior(points.levels[0], kBorder);
  ASSERT_GT(points.levels[0].size(), 1000U);

  const vo::AlignOptions options{
      .max_iterations = 100, .min_translation = 1e-10, .min_rotation_deg = 1e-8};
  const vo::AlignResult ours = vo::align(points, current, SE3(), options);
  ASSERT_EQ(ours.points, points.levels[0].size());
  const SE3 theirs =
      solve_with_ceres(points.levels[0], current.levels[0], SE3(), options.loss_scale);
  EXPECT_THAT(ours.T_cur_ref, PoseNear(theirs, support::PoseTolerance{.translation_m = 1e-6,
                                                                      .rotation_deg = 6e-5}));
}

}  // namespace
