#include "vo/alignment/align.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/support/pose_near.h"
#include "tests/support/textured_plane.h"
#include "vo/core/error.h"

namespace {

using support::PoseNear;
using support::small_camera;
using vo::SE3;
using vo::Termination;
using vo::Vector6d;

vo::FramePyramid pyramid_at(const SE3& T_world_camera) {
  vo::FramePyramid pyramid = vo::build_pyramid(
      support::TexturedPlane().render(small_camera(), T_world_camera), small_camera(), {});
  vo::add_edges(pyramid, {});
  return pyramid;
}

SE3 motion(double size) {
  Vector6d xi;
  xi << 0.02, -0.015, 0.025, 0.01, 0.012, -0.02;
  return SE3::exp(size * xi);
}

vo::AlignResult align_pair(const SE3& T_world_ref, const SE3& T_world_cur,
                           const vo::AlignOptions& options = {}) {
  const vo::FramePyramid reference = pyramid_at(T_world_ref);
  const vo::FramePyramid current = pyramid_at(T_world_cur);
  return vo::align(vo::edge_points(reference, current, {}), current, SE3(), options);
}

TEST(Align, AnIdenticalPairGivesTheIdentity) {
  const vo::AlignResult result = align_pair(motion(3), motion(3));
  EXPECT_EQ(result.termination, Termination::converged);
  EXPECT_THAT(result.T_cur_ref, PoseNear(SE3(), support::PoseTolerance{1e-12, 1e-10}));
  EXPECT_EQ(result.iterations, 0) << "no step is worth taking";
  EXPECT_NEAR(result.correlation, 1, 1e-9);
}

TEST(Align, RecoversTheMotionOfATexturedPlane) {
  for (const double size : {-1.0, 0.3, 1.0, 1.5}) {
    const SE3 T_world_cur = motion(size);
    const vo::AlignResult result = align_pair(SE3(), T_world_cur);
    EXPECT_TRUE(result.usable());
    EXPECT_THAT(result.T_cur_ref,
                PoseNear(T_world_cur.inverse(), support::PoseTolerance{5e-4, 0.02}))
        << size;
    EXPECT_GT(result.correlation, 0.98);
  }
}

/// The step that is taken unchecked leads most of the way to where finer limits lead.
TEST(Align, TheLastStepCountsWhereItIsTaken) {
  const auto aligned_to = [](double min_translation, double last_step) {
    return align_pair(SE3(), motion(1),
                      {.min_translation = min_translation,
                       .min_rotation_deg = 50 * min_translation,
                       .last_step = last_step})
        .T_cur_ref;
  };
  const SE3 least = aligned_to(1e-8, 1);
  const double left = (least.inverse() * aligned_to(2e-3, 1)).log().norm();
  const double taken = (least.inverse() * aligned_to(1e-6, 2e3)).log().norm();
  EXPECT_GT(left, 1e-5) << "else there is nothing to see";
  EXPECT_LT(taken, 0.5 * left);
}

/// The robust loss curves less than its weights say; the minimum is the same.
TEST(Align, StepsThatKnowTheCurvatureReachTheSamePoseSooner) {
  vo::AlignOptions options{.step_limit_growth = 5,
                           .formulation = vo::Formulation::esm,
                           .loss = vo::RobustLoss::student_t,
                           .scale = vo::LossScale::residuals};
  int plain_iterations = 0;
  int secant_iterations = 0;
  for (const double size : {-1.5, -1.0, -0.5, 0.5, 1.0, 1.5}) {
    options.secant = false;
    const vo::AlignResult plain = align_pair(SE3(), motion(size), options);
    options.secant = true;
    const vo::AlignResult secant = align_pair(SE3(), motion(size), options);
    EXPECT_THAT(secant.T_cur_ref, PoseNear(plain.T_cur_ref, support::PoseTolerance{1e-4, 2e-3}));
    plain_iterations += plain.iterations;
    secant_iterations += secant.iterations;
  }
  EXPECT_LT(secant_iterations, 0.9 * plain_iterations);
}

/// Coarse levels only lead to where the finest one starts.
TEST(Align, FewerReferencesOnCoarseLevelsEndAtTheSamePose) {
  const vo::FramePyramid first = pyramid_at(SE3());
  const vo::FramePyramid second = pyramid_at(motion(0.4));
  const vo::FramePyramid current = pyramid_at(motion(1));
  const vo::EdgePoints first_points = vo::edge_points(first, current, {});
  const vo::EdgePoints second_points = vo::edge_points(second, current, {});
  const std::vector<vo::AlignReference> references{{first_points, SE3()},
                                                   {second_points, motion(0.4)}};
  vo::AlignOptions options{
      .min_translation = 1e-7, .min_rotation_deg = 1e-5, .brightness = vo::BrightnessModel::affine};
  const vo::AlignResult all = vo::align(references, {current}, SE3(), options);
  options.coarse_references = 1;
  const vo::AlignResult fewer = vo::align(references, {current}, SE3(), options);
  EXPECT_EQ(fewer.points, all.points) << "on the finest level";
  EXPECT_THAT(fewer.T_cur_ref, PoseNear(all.T_cur_ref, support::PoseTolerance{1e-5, 1e-3}));
}

TEST(Align, IsAPureFunction) {
  const vo::AlignResult first = align_pair(SE3(), motion(1));
  const vo::AlignResult second = align_pair(SE3(), motion(1));
  EXPECT_EQ(first.T_cur_ref.translation(), second.T_cur_ref.translation());
  EXPECT_EQ(first.T_cur_ref.rotation().coeffs(), second.T_cur_ref.rotation().coeffs());
  EXPECT_EQ(first.cost, second.cost);
}

TEST(Align, NeverEndsWorseThanItsGuess) {
  const vo::FramePyramid reference = pyramid_at(SE3());
  const vo::FramePyramid current = pyramid_at(motion(4));
  vo::EdgePoints points = vo::edge_points(reference, current, {});
  points.levels.resize(1);
  vo::FramePyramid finest = current;
  finest.levels.resize(1);
  const double scale = vo::AlignOptions().loss_scale;
  const vo::PointEquations start =
      vo::linearize({points.levels[0], finest.levels[0], SE3(), {}, {}}, {}, {scale, {}});
  const double before = start.cost / (scale * scale * static_cast<double>(start.total));
  for (const int iterations : {1, 2, 5, 30}) {
    const vo::AlignOptions options{.max_iterations = iterations};
    EXPECT_LE(vo::align(points, finest, SE3(), options).cost, before * (1 + 1e-9));
  }
}

TEST(Align, CovarianceIsSymmetricAndPositive) {
  const vo::AlignResult result = align_pair(SE3(), motion(1));
  EXPECT_LT((result.covariance - result.covariance.transpose()).norm(),
            1e-9 * result.covariance.norm());
  const Eigen::SelfAdjointEigenSolver<vo::Matrix6d> solver(result.covariance);
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0);
  EXPECT_LT(solver.eigenvalues().maxCoeff(), 1e-6) << "within a millimetre and a milliradian";
}

TEST(Align, SaysWhenThereAreTooFewPoints) {
  const vo::FramePyramid reference = pyramid_at(SE3());
  vo::EdgePoints none = vo::edge_points(reference, reference, {.max_depth = 0.2});
  const vo::AlignResult result = vo::align(none, reference, SE3(), {});
  EXPECT_EQ(result.termination, Termination::too_few_points);
  EXPECT_FALSE(result.usable());
}

/// Vertical stripes say nothing about a motion along them.
TEST(Align, SaysWhenTheImageDoesNotDetermineThePose) {
  vo::RgbdFrame frame{0, vo::ByteImage(240, 320), vo::DepthImage(240, 320, 2.0F)};
  for (int u = 0; u < 320; ++u) {
    frame.image.col(u) = static_cast<uchar>(128 + 100 * std::sin(0.2 * u));
  }
  vo::FramePyramid pyramid = vo::build_pyramid(frame, small_camera(), {.levels = 1});
  vo::add_edges(pyramid, {});
  const vo::AlignResult result =
      vo::align(vo::edge_points(pyramid, pyramid, {}), pyramid, motion(0.01), {});
  EXPECT_EQ(result.termination, Termination::singular);
  EXPECT_FALSE(result.usable());
}

TEST(Align, OptionsOutOfRangeAreErrors) {
  EXPECT_THROW(vo::AlignOptions{.max_iterations = 0}.validate(), vo::Error);
  EXPECT_THROW(vo::AlignOptions{.last_step = 0.5}.validate(), vo::Error);
  EXPECT_THROW(vo::AlignOptions{.coarse_references = -1}.validate(), vo::Error);
  EXPECT_NO_THROW(vo::AlignOptions{.threads = 1024}.validate());
  EXPECT_THROW(vo::AlignOptions{.threads = 70'000}.validate(), vo::Error);
  EXPECT_THROW(vo::AlignOptions{.loss_scale = 0}.validate(), vo::Error);
  EXPECT_THROW(vo::AlignOptions{.min_points = 6}.validate(), vo::Error);
}

}  // namespace
