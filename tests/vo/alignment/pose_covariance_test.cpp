#include "vo/alignment/pose_covariance.h"

#include <array>
#include <cmath>
#include <optional>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/alignment/align.h"
#include "vo/core/fields.h"

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

vo::FramePyramid pyramid_of_view(const SE3& T_world_camera) {
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
  vo::AlignMemory memory;
  const vo::JointScores& scores = problem.scores(system, SE3(), memory);
  ASSERT_EQ(scores.references.size(), references.size());
  Vector6d sum = Vector6d::Zero();
  for (const vo::CellScores& reference : scores.references) {
    for (const Vector6d& cell : reference.b()) {
      sum += cell;
    }
  }
  EXPECT_LT((sum - system.b).norm(), 1e-4 * system.b.norm());
}

/// Sum over six directions of the squared change of a pose by a velocity that is off in each.
template <typename AlignedWith>
vo::Matrix6d scatter_by_velocity(const Vector6d& doubt, const AlignedWith& aligned_with) {
  vo::Matrix6d sum = vo::Matrix6d::Zero();
  const SE3 certain = aligned_with(Vector6d::Zero()).T_cur_ref;
  for (int k = 0; k < 6; ++k) {
    Vector6d off = Vector6d::Zero();
    off[k] = (k < 3 ? doubt.head<3>() : doubt.tail<3>()).norm() / std::sqrt(3.0);
    const Vector6d change = (aligned_with(off).T_cur_ref * certain.inverse()).log();
    sum += change * change.transpose();
  }
  return sum;
}

/// A rolling shutter whose velocities are in doubt adds the squares of what others would change.
class DoubtfulVelocity : public testing::Test {
 protected:
  vo::AlignResult aligned(const vo::FrameVelocity& of_reference,
                          const std::optional<vo::PreviousFrame>& before_current) const {
    const std::array references{vo::AlignReference{points_, SE3(), nullptr, of_reference}};
    return vo::align(references, vo::AlignCurrent{current_, nullptr, before_current},
                     motion().inverse(), options_);
  }

  static void expect_near(const vo::Matrix6d& added, const vo::Matrix6d& expected) {
    EXPECT_GT(expected.norm(), 1e-10);
    EXPECT_LT((added - expected).norm(), 0.15 * expected.norm());
  }

  const Vector6d doubt_ = (Vector6d() << 0.002, 0.001, -0.002, 0.005, 0.008, -0.006).finished();
  const vo::FramePyramid first_ = pyramid_of_view(SE3());
  const vo::FramePyramid current_ = pyramid_of_view(motion());
  const vo::EdgePoints points_ = vo::edge_points(first_, first_, {});
  const vo::AlignOptions options_{
      .min_translation = 1e-9, .min_rotation_deg = 1e-7, .readout = {.seconds = 0.02}};
};

TEST_F(DoubtfulVelocity, OfAReferenceIsInTheCovariance) {
  const vo::Matrix6d expected =
      scatter_by_velocity(doubt_, [&](const Vector6d& off) { return aligned({.twist = off}, {}); });
  expect_near(aligned({.doubt = doubt_}, {}).covariance - aligned({}, {}).covariance, expected);
}

TEST_F(DoubtfulVelocity, OfTheCurrentFrameIsInTheCovariance) {
  constexpr double kSeconds = 10;  // so long that the pose that is sought hardly changes velocities
  const auto velocity_changed_by = [&](const Vector6d& off) {
    return aligned(
        {}, vo::PreviousFrame{motion().inverse(), kSeconds, vo::MeanVelocity{-2 * off, kSeconds}});
  };
  const vo::AlignResult certain = velocity_changed_by(Vector6d::Zero());
  expect_near(velocity_changed_by(doubt_).covariance - certain.covariance,
              scatter_by_velocity(doubt_, velocity_changed_by));
}

/// An image of lines exposed one after the other shows a camera that accelerates at its mean place.
TEST_F(DoubtfulVelocity, AccelerationWhileAnImageIsTakenIsInTheCovariance) {
  constexpr int kSteps = 200;
  const double readout = options_.readout.seconds;
  const double exposure = 0.7 * readout;
  double half_mean_square = 0;  // s^2, of the time from the middle of the image
  for (int line = 0; line < kSteps; ++line) {
    for (int instant = 0; instant < kSteps; ++instant) {
      const double t =
          readout * ((line + 0.5) / kSteps - 0.5) + exposure * ((instant + 0.5) / kSteps - 0.5);
      half_mean_square += t * t / (2.0 * kSteps * kSteps);
    }
  }
  vo::FrameVelocity accelerated;
  accelerated.acceleration << 3, 0, 4, 0, 12, 5;
  const vo::AlignResult result = aligned(accelerated, {});
  Vector6d variance;
  variance << Vector6d::Constant(25.0 / 3).head<3>(), Vector6d::Constant(169.0 / 3).head<3>();
  const vo::Matrix6d Ad = adjoint(result.T_cur_ref);
  expect_near(result.covariance - aligned({}, {}).covariance,
              half_mean_square * half_mean_square * Ad * variance.asDiagonal() * Ad.transpose());
}

}  // namespace
