#include "vo/alignment/noise_curvature.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "vo/core/fields.h"
#include "vo/residuals/linearize.h"

namespace {

using support::small_camera;
using vo::Matrix6d;
using vo::SE3;
using vo::Vector6d;

constexpr double kImageNoise = 6;  // grey levels, standard deviation

constexpr double kWallDistance = 2;  // m

/// Parallel stripes on a wall, seen from so many pixels further to the right. Every row shows the
/// same, which has edges.
vo::RgbdFrame striped_frame(int shift_px = 0) {
  vo::RgbdFrame frame = support::blank_frame(small_camera(), 0, 0);
  frame.depth = kWallDistance;
  for (int u = 0; u < frame.image.cols; ++u) {
    frame.image.col(u) = (u + shift_px) / 13 % 2 == 0 ? 90 : 160;
  }
  return frame;
}

vo::FramePyramid finest_level_of(const vo::RgbdFrame& frame, std::uint64_t seed) {
  vo::FramePyramid pyramid = vo::build_pyramid(support::with_noise(frame, kImageNoise, seed),
                                               small_camera(), {.levels = 1});
  vo::add_edges(pyramid, {});
  return pyramid;
}

/// A pair of noisy images of a wall, H of whose points is compared with what noise adds to it.
struct NoisyPair {
  vo::FramePyramid reference, current;
  vo::EdgePoints points;
  SE3 T_cur_ref;

  NoisyPair(const vo::RgbdFrame& frame, vo::PointSelection selection, const SE3& T_cur_ref_of_pair)
      : NoisyPair(frame, frame, selection, T_cur_ref_of_pair) {}

  NoisyPair(const vo::RgbdFrame& frame_ref, const vo::RgbdFrame& frame_cur,
            vo::PointSelection selection, const SE3& T_cur_ref_of_pair)
      : reference(finest_level_of(frame_ref, 1)),
        current(finest_level_of(frame_cur, 2)),
        points(vo::edge_points(reference, reference, {.selection = selection})),
        T_cur_ref(T_cur_ref_of_pair) {}

  /// Returns the share of noise in H in each of six independent directions, ascending, both with
  /// the brightness eliminated.
  Vector6d noise_shares() const {
    const vo::PointView view{points.levels[0], current.levels[0], T_cur_ref, {}, {}};
    const vo::AlignOptions options{
        .formulation = vo::Formulation::esm, .loss = vo::RobustLoss::none, .loss_scale = 1};
    const vo::ResidualModel model{1, {}};
    vo::PointTerms terms;
    vo::compute_point_terms(view, options, model, terms);
    const Matrix6d noise = vo::noise_equations(view, terms).eliminated<2>().H;
    const Matrix6d H = vo::linearize(view, options, model).eliminated<2>().H;
    return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d>(noise, H, Eigen::EigenvaluesOnly)
        .eigenvalues();
  }
};

/// The pixels of one image lie between those of the other everywhere in between.
SE3 between_pixels() {
  return SE3::exp((Vector6d() << 0.01, 0.02, 0.03, 0.01, -0.01, 0.05).finished());
}

TEST(NoiseCurvature, IsAllThatWhiteNoiseHasInEveryDirection) {
  const NoisyPair pair(support::blank_frame(small_camera(), 128, 0), vo::PointSelection::all,
                       between_pixels());
  const Vector6d share = pair.noise_shares();
  EXPECT_NEAR(share.mean(), 1, 0.15);
  EXPECT_GT(share.minCoeff(), 0.5) << share.transpose();
  EXPECT_LT(share.maxCoeff(), 2) << share.transpose();
}

TEST(NoiseCurvature, IsAllThatStripesHaveAlongThem) {
  const NoisyPair pair(striped_frame(), vo::PointSelection::edges, SE3());
  const Vector6d share = pair.noise_shares();
  EXPECT_GT(share[5], 0.8) << share.transpose();
  EXPECT_LT(share[5], 1.2) << share.transpose();
  EXPECT_LT(share[0], 0.1) << share.transpose();
}

/// Two views of stripes whose camera has moved by 30 px across them; the current one may have no
/// depth.
NoisyPair across_stripes(bool current_has_depth) {
  constexpr int kShift = 30;  // px
  vo::RgbdFrame current = striped_frame(kShift);
  if (!current_has_depth) {
    current.depth = {};
  }
  const double moved = kShift * kWallDistance / small_camera().fx;
  return {striped_frame(), current, vo::PointSelection::edges,
          SE3::exp((Vector6d() << -moved, 0, 0, 0, 0, 0).finished())};
}

TEST(NoiseCurvature, IsAllThatStripesHaveAlongThemWhereTheCameraMovesAcross) {
  const Vector6d share = across_stripes(true).noise_shares();
  EXPECT_GT(share[5], 0.8) << share.transpose();
  EXPECT_LT(share[0], 0.1) << share.transpose();
}

TEST(NoiseCurvature, IsWhatNoInclinationExplainsWhereThereIsNoDepth) {
  const Vector6d share = across_stripes(false).noise_shares();
  EXPECT_LT(share[5], 0.5) << share.transpose();
}

TEST(NoiseCurvature, IsLittleWhereTextureRunsInAllDirections) {
  const NoisyPair pair(support::TexturedPlane().render(small_camera(), SE3()),
                       vo::PointSelection::edges, SE3());
  EXPECT_LT(pair.noise_shares().maxCoeff(), 0.2);
}

/// With the reference's gradients taken as they are, the greatest share is 1; with the change of
/// the images' blur taken for noise, it is 0.15.
TEST(NoiseCurvature, IsLittleWhereAnInclinedSurfaceIsSeenFromElsewhere) {
  constexpr double kInclination = 50;  // deg
  const double angle = kInclination * std::numbers::pi / 180;
  const support::TexturedPlane table{.normal = {0, -std::sin(angle), -std::cos(angle)},
                                     .point = {0, 0, 1}};
  const SE3 T_ref_cur = SE3::exp((Vector6d() << 0.8, 0, 0, 0, -0.4, 0).finished());
  const NoisyPair pair(table.render(small_camera(), SE3()), table.render(small_camera(), T_ref_cur),
                       vo::PointSelection::edges, T_ref_cur.inverse());
  EXPECT_LT(pair.noise_shares().maxCoeff(), 0.12);
}

/// A matrix that is not diagonal, and positive definite.
Matrix6d coupled() {
  Matrix6d A = Matrix6d::Identity();
  for (int k = 0; k < 6; ++k) {
    A(k, (k + 2) % 6) = 0.3 + 0.1 * k;
  }
  return A * A.transpose();
}

TEST(NoiseFreeCurvature, InvertsTheDifferenceWhereNoiseIsLittle) {
  const Matrix6d H = 100 * coupled();
  const Matrix6d noise = Vector6d(1, 2, 3, 4, 5, 6).asDiagonal();
  const vo::NoiseFreeCurvature curvature(H, noise);
  EXPECT_LT((curvature.inverse() * (H - noise) - Matrix6d::Identity()).norm(), 1e-6);
}

TEST(NoiseFreeCurvature, KeepsATenthOfHWhereAllIsNoise) {
  const Matrix6d H = coupled();
  const vo::NoiseFreeCurvature curvature(H, H);
  EXPECT_NEAR(curvature.noise_share(), 1, 1e-9);
  EXPECT_LT((curvature.inverse() * H / 10 - Matrix6d::Identity()).norm(), 1e-6);
}

TEST(NoiseFreeCurvature, IsAllOfHWithoutNoise) {
  const Matrix6d H = coupled();
  const vo::NoiseFreeCurvature curvature(H, Matrix6d::Zero());
  EXPECT_EQ(curvature.noise_share(), 0);
  EXPECT_LT((curvature.inverse() * H - Matrix6d::Identity()).norm(), 1e-6);
}

}  // namespace
