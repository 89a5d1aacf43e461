#include <array>
#include <memory>
#include <vector>

#include <ceres/ceres.h>
#include <ceres/rotation.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/cross/image_function.h"
#include "tests/support/plane_view.h"
#include "tests/support/pose_near.h"
#include "vo/tracking/window_adjustment.h"

namespace {

using support::ImageFunction;
using support::PoseNear;
using support::small_camera;
using vo::SE3;
using vo::Vector6d;

/// A point of one frame by its inverse depth, in the image of another: residual over the loss's
/// scale as a function of both frames' poses [rotation vector; translation] from the world.
struct PointResidual {
  const ImageFunction* image;
  Eigen::Vector3d ray;  ///< of depth 1
  double intensity;
  double scale;

  template <typename T>
  bool operator()(const T* host, const T* target, const T* inverse_depth, T* residual) const {
    const T in_host[3] = {ray.x() / *inverse_depth - host[3], ray.y() / *inverse_depth - host[4],
                          ray.z() / *inverse_depth - host[5]};
    const T back[3] = {-host[0], -host[1], -host[2]};
    T in_world[3];
    ceres::AngleAxisRotatePoint(back, in_host, in_world);
    T p[3];
    ceres::AngleAxisRotatePoint(target, in_world, p);
    for (int i = 0; i < 3; ++i) {
      p[i] += target[3 + i];
    }
    const vo::PinholeCamera camera = small_camera();
    residual[0] =
        ((*image)(p[0] / p[2] * camera.fx + camera.cx, p[1] / p[2] * camera.fy + camera.cy) -
         intensity) /
        scale;
    return true;
  }
};

/// An inverse depth beside what was measured, in standard deviations.
struct DepthResidual {
  double measured;
  double sigma;

  template <typename T>
  bool operator()(const T* inverse_depth, T* residual) const {
    residual[0] = (*inverse_depth - measured) / sigma;
    return true;
  }
};

std::array<double, 6> parameters(const SE3& T) {
  const Eigen::AngleAxisd rotation(T.rotation());
  const Eigen::Vector3d w = rotation.angle() * rotation.axis();
  const Eigen::Vector3d& t = T.translation();
  return {w.x(), w.y(), w.z(), t.x(), t.y(), t.z()};
}

SE3 transform(const std::array<double, 6>& values) {
  Vector6d rotation = Vector6d::Zero();
  rotation.tail<3>() = Eigen::Map<const Eigen::Vector3d>(values.data());
  return {SE3::exp(rotation).rotation(), Eigen::Map<const Eigen::Vector3d>(values.data() + 3)};
}

struct CeresWindow {
  std::vector<std::array<double, 6>> poses;
  std::vector<std::vector<double>> inverse_depth;
};

void add_point(const std::vector<vo::WindowFrame>& frames, const std::vector<ImageFunction>& images,
               std::size_t host, std::size_t i, double scale, CeresWindow& window,
               ceres::Problem& problem) {
  const vo::EdgePointLevel& points = frames[host].points;
  const Eigen::Vector3d ray(points.x_ref[i] / points.z_ref[i], points.y_ref[i] / points.z_ref[i],
                            1);
  double* inverse_depth = &window.inverse_depth[host][i];
  for (std::size_t target = 0; target < frames.size(); ++target) {
    if (target != host) {
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<PointResidual, 1, 6, 6, 1>(
              new PointResidual{&images[target], ray, points.intensity[i], scale}),
          new ceres::HuberLoss(1), window.poses[host].data(), window.poses[target].data(),
          inverse_depth);
    }
  }
  const double z = frames[host].measured_depth[i];
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<DepthResidual, 1, 1>(
                               new DepthResidual{1 / z, points.depth_sigma[i] / (z * z)}),
                           nullptr, inverse_depth);
}

CeresWindow solve_with_ceres(const std::vector<vo::WindowFrame>& frames, double scale) {
  CeresWindow window;
  std::vector<ImageFunction> images;
  for (const vo::WindowFrame& frame : frames) {
    window.poses.push_back(parameters(frame.T_frame_world));
    std::vector<double> inverse_depth;
    for (const float z : frame.points.z_ref) {
      inverse_depth.push_back(1 / static_cast<double>(z));
    }
    window.inverse_depth.push_back(std::move(inverse_depth));
    images.emplace_back(*frame.image);
  }
  ceres::Problem problem;
  for (std::size_t host = 0; host < frames.size(); ++host) {
    for (std::size_t i = 0; i < frames[host].points.size(); ++i) {
      add_point(frames, images, host, i, scale, window, problem);
    }
    if (frames[host].held) {
      problem.SetParameterBlockConstant(window.poses[host].data());
    }
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return window;
}

TEST(AdjustWindow, FindsWhatCeresFinds) {
  const std::vector<SE3> T_world{
      SE3(), SE3::exp((Vector6d() << 0.03, 0.01, 0.01, 0.004, -0.01, 0.005).finished()),
      SE3::exp((Vector6d() << -0.01, 0.04, 0.01, -0.012, 0, 0.01).finished())};
  constexpr int kBorder = 60;  // px; no point leaves a view: both objectives sum over the same
  constexpr std::size_t kStep = 5;
  constexpr double kSmooth = 4;  // px; central differences are then near to what is looked up
  std::vector<vo::FramePyramid> pyramids;
  for (const SE3& T_world_camera : T_world) {
    pyramids.push_back(support::plane_view(T_world_camera));
    cv::Mat& intensity = pyramids.back().levels.front().intensity;
    cv::GaussianBlur(intensity, intensity, {}, kSmooth);
  }
  std::vector<vo::WindowFrame> frames;
  for (std::size_t f = 0; f < pyramids.size(); ++f) {
    const vo::EdgePointLevel points = support::interior(
        vo::edge_points(pyramids[f], pyramids[f], {}).levels.front(), kBorder, kStep);
    ASSERT_GT(points.size(), 100U);
    std::vector<float> measured = points.z_ref;
    for (std::size_t i = 0; i < measured.size(); ++i) {
      measured[i] *= 1 + 0.01F * (static_cast<float>(i % 5) - 2);
    }
    frames.push_back({.image = &pyramids[f].levels.front(),
                      .points = vo::at_depths(points, measured),
                      .measured_depth = measured,
                      .T_frame_world = T_world[f].inverse(),
                      .velocity = {},
                      .held = f == 0});
    frames.back().points.depth_sigma.assign(points.size(), 0.02F);
  }
  const vo::AlignOptions options{.loss_scale = 0.05};
  const CeresWindow theirs = solve_with_ceres(frames, options.loss_scale);
  vo::adjust_window(frames,
                    {.adjust = vo::WindowAdjustment::depth, .max_iterations = 100, .converged = 0},
                    options);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    EXPECT_THAT(frames[f].T_frame_world,
                PoseNear(transform(theirs.poses[f]), support::PoseTolerance{2e-6, 1e-4}));
    for (std::size_t i = 0; i < frames[f].points.size(); ++i) {
      EXPECT_NEAR(1 / frames[f].points.z_ref[i], theirs.inverse_depth[f][i], 1e-4) << f << " " << i;
    }
  }
}

}  // namespace
