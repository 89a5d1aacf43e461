#include "vo/tracking/pose_covariance.h"

#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/core/fields.h"
#include "vo/tracking/align.h"

namespace {

using support::small_camera;
using vo::SE3;
using vo::Vector6d;

/// Grey levels, standard deviation.
constexpr double kNoise = 4;

vo::FramePyramid noisy_pyramid(vo::RgbdFrame frame, std::mt19937& random) {
  std::normal_distribution<double> noise(0, kNoise);
  vo::ByteImage image = frame.image.clone();
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      image(v, u) = cv::saturate_cast<uchar>(image(v, u) + noise(random));
    }
  }
  frame.image = image;
  vo::FramePyramid pyramid = vo::build_pyramid(frame, small_camera(), {});
  vo::add_edges(pyramid, {});
  return pyramid;
}

vo::FramePyramid pyramid_at(const SE3& T_world_camera) {
  vo::FramePyramid pyramid = vo::build_pyramid(
      support::TexturedPlane().render(small_camera(), T_world_camera), small_camera(), {});
  vo::add_edges(pyramid, {});
  return pyramid;
}

SE3 motion() {
  Vector6d xi;
  xi << 0.01, -0.008, 0.012, 0.005, 0.006, -0.01;
  return SE3::exp(xi);
}

vo::Matrix6d sandwich_at(const vo::EdgePoints& points, const vo::FramePyramid& current,
                         const SE3& T_cur_ref, const vo::AlignOptions& options) {
  const std::array references{vo::AlignReference{points, SE3()}};
  const vo::AlignCurrent frame{current, nullptr, {}};
  vo::JointProblem problem(references, frame, 0, options);
  problem.match_brightness(T_cur_ref);
  problem.estimate_scales(T_cur_ref);
  return vo::sandwich_covariance(problem, problem.linearize(T_cur_ref), T_cur_ref);
}

/// Squared errors about their mean over predicted covariances, per degree of freedom; 1 is right.
double scatter_over_prediction(const vo::AlignOptions& options) {
  constexpr int kTrials = 60;
  const vo::RgbdFrame reference = support::TexturedPlane().render(small_camera(), SE3());
  const vo::RgbdFrame current = support::TexturedPlane().render(small_camera(), motion());
  std::mt19937 random(1);
  std::vector<Vector6d> errors;
  vo::Matrix6d covariance = vo::Matrix6d::Zero();
  Vector6d mean = Vector6d::Zero();
  for (int i = 0; i < kTrials; ++i) {
    const vo::FramePyramid ref = noisy_pyramid(reference, random);
    const vo::FramePyramid cur = noisy_pyramid(current, random);
    const vo::EdgePoints points = vo::edge_points(ref, cur, {});
    const SE3 T_cur_ref = vo::align(points, cur, motion().inverse(), options).T_cur_ref;
    errors.push_back((T_cur_ref * motion()).log());
    mean += errors.back() / kTrials;
    covariance += sandwich_at(points, cur, T_cur_ref, options) / kTrials;
  }
  double squares = 0;
  for (const Vector6d& error : errors) {
    squares += (error - mean).dot(covariance.ldlt().solve(error - mean));
  }
  return squares / (6 * (kTrials - 1));
}

TEST(PoseCovariance, PredictsTheScatterOfPosesUnderFreshNoise) {
  const double ratio = scatter_over_prediction({.formulation = vo::Formulation::esm,
                                                .loss = vo::RobustLoss::student_t,
                                                .scale = vo::LossScale::residuals,
                                                .brightness = vo::BrightnessModel::affine});
  EXPECT_GT(ratio, 0.5);
  EXPECT_LT(ratio, 2);
}

TEST(PoseCovariance, DoesNotDependOnTheLossOrItsScale) {
  for (const vo::RobustLoss loss : {vo::RobustLoss::none, vo::RobustLoss::huber}) {
    const double ratio = scatter_over_prediction({.loss = loss, .loss_scale = 20.0 / 255});
    EXPECT_GT(ratio, 0.5) << vo::to_string(loss);
    EXPECT_LT(ratio, 2) << vo::to_string(loss);
  }
}

/// The cells' sums are the system's b, whatever they are weighted and projected with.
TEST(PoseCovariance, CellsOfAllReferencesSumToTheSystemsRightSide) {
  std::mt19937 random(2);
  const vo::FramePyramid first =
      noisy_pyramid(support::TexturedPlane().render(small_camera(), SE3()), random);
  const vo::FramePyramid current =
      noisy_pyramid(support::TexturedPlane().render(small_camera(), motion()), random);
  const vo::EdgePoints points = vo::edge_points(first, first, {});
  const vo::EdgePoints own = vo::edge_points(current, current, {});
  const std::array references{vo::AlignReference{points, SE3(), &first},
                              vo::AlignReference{points, SE3(), &first}};
  const vo::AlignCurrent frame{current, &own, {}};
  const vo::AlignOptions options{.brightness = vo::BrightnessModel::affine, .depth_noise = 1};
  const vo::JointProblem problem(references, frame, 0, options);
  const vo::JointSystem system = problem.linearize(SE3());
  const vo::JointScores scores = problem.scores(system, SE3());
  ASSERT_EQ(scores.references.size(), references.size());
  Vector6d sum = Vector6d::Zero();
  for (const vo::CellScores& reference : scores.references) {
    for (const Vector6d& cell : reference.b()) {
      sum += cell;
    }
  }
  EXPECT_LT((sum - system.b).norm(), 1e-4 * system.b.norm());
}

/// A rolling shutter whose velocity is in doubt adds the square of what that velocity would change.
TEST(PoseCovariance, HoldsWhatDoubtfulVelocitiesWouldChange) {
  const vo::FramePyramid first = pyramid_at(SE3());
  const vo::FramePyramid current = pyramid_at(motion());
  const vo::EdgePoints points = vo::edge_points(first, first, {});
  const vo::AlignOptions options{
      .min_translation = 1e-9, .min_rotation_deg = 1e-7, .readout = 0.02};
  const Vector6d doubt = (Vector6d() << 0.002, 0.001, -0.002, 0.005, 0.008, -0.006).finished();
  const auto aligned = [&](const vo::FrameVelocity& velocity) {
    const std::array references{vo::AlignReference{points, SE3(), nullptr, velocity}};
    return vo::align(references, vo::AlignCurrent{current}, motion().inverse(), options);
  };
  const vo::AlignResult certain = aligned({});
  const vo::AlignResult doubtful = aligned({Vector6d::Zero(), doubt});
  const Vector6d change =
      (aligned({doubt, Vector6d::Zero()}).T_cur_ref * certain.T_cur_ref.inverse()).log();
  const vo::Matrix6d expected = change * change.transpose();
  const vo::Matrix6d added = doubtful.covariance - certain.covariance;
  EXPECT_GT(change.norm(), 1e-5);
  EXPECT_LT((added - expected).norm(), 0.1 * expected.norm());
}

}  // namespace
