#include "vo/alignment/joint_problem.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "vo/residuals/align_options.h"

namespace {

using vo::Matrix6d;
using vo::RobustLoss;
using vo::SE3;
using vo::Vector6d;

/// The prior that linearize() adds to the brightness block of H, per point and the one more.
constexpr double kBrightnessPrior = 1e-3;

SE3 pose(double x, double y, double z, double a, double b, double c) {
  return SE3::exp((Vector6d() << x, y, z, a, b, c).finished());
}

vo::PinholeCamera camera() {
  return vo::PinholeCamera::from_horizontal_fov(320, 240, 60);
}

/// An image that bilinear interpolation and central differences represent exactly: its slopes are
/// the derivatives of what is looked up.
vo::FramePyramid bilinear_frame(float du, float dv, float dudv) {
  vo::PyramidLevel level{camera(), {}, vo::GrayImage(240, 320), {}, {}};
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      level.intensity(v, u) = 0.5F + du * static_cast<float>(u - 160) +
                              dv * static_cast<float>(v - 120) +
                              dudv * static_cast<float>((u - 160) * (v - 120));
    }
  }
  return {0, {level}};
}

/// A grid of points on a curved surface, in view from anywhere nearby, as a frame would show them.
vo::EdgePoints grid_points(const vo::FramePyramid& frame, int step) {
  vo::EdgePoints points;
  points.levels.resize(1);
  vo::EdgePointLevel& level = points.levels[0];
  for (int v = 50; v < 190; v += step) {
    for (int u = 50; u < 270; u += step) {
      const Eigen::Vector3d p = camera().unproject({u, v}, 1.5 + 0.002 * u + 2e-5 * v * v);
      level.x_ref.push_back(static_cast<float>(p.x()));
      level.y_ref.push_back(static_cast<float>(p.y()));
      level.z_ref.push_back(static_cast<float>(p.z()));
      level.intensity.push_back(frame.levels[0].intensity(v, u) +
                                0.01F * static_cast<float>(u % 3));
      level.pixel.emplace_back(u, v);
    }
  }
  return points;
}

/// A frame and two references, each looked up in the other: four pairs of images.
struct SymmetricPair {
  vo::FramePyramid first = bilinear_frame(2e-3F, -1e-3F, 1e-5F);
  vo::FramePyramid second = bilinear_frame(-1.5e-3F, 2e-3F, 2e-5F);
  vo::FramePyramid frame = bilinear_frame(1.8e-3F, 1.2e-3F, -1e-5F);
  vo::EdgePoints first_points = grid_points(first, 9);
  vo::EdgePoints second_points = grid_points(second, 11);
  vo::EdgePoints frame_points = grid_points(frame, 7);
  SE3 T_first_second = pose(0.05, -0.04, 0.02, 0.02, -0.03, 0.04);
  SE3 T_cur_first = pose(-0.03, 0.02, 0.04, -0.01, 0.02, 0.03);
  std::vector<vo::AlignReference> references{{first_points, SE3(), &first},
                                             {second_points, T_first_second, &second}};
  vo::AlignCurrent current{frame, &frame_points, {}};

  /// The views of the four pairs written down one by one: forward, forward, backward, backward.
  std::vector<vo::PointView> views(const SE3& T_cur_ref) const {
    const SE3 T_cur_second = T_cur_ref * T_first_second;
    return {{first_points.levels[0], frame.levels[0], T_cur_ref, {}, {}},
            {second_points.levels[0], frame.levels[0], T_cur_second, {}, {}},
            {frame_points.levels[0], first.levels[0], T_cur_ref.inverse(), {}, {}},
            {frame_points.levels[0], second.levels[0], T_cur_second.inverse(), {}, {}}};
  }
};

double summed_loss(const vo::JointSystem& system) {
  return system.cost * static_cast<double>(system.total);
}

TEST(Adjoint, MovesAnIncrementFromRightToLeft) {
  const SE3 T = pose(0.3, -0.2, 0.5, 0.4, -0.7, 1.1);
  for (int i = 0; i < 6; ++i) {
    const Vector6d delta = 0.3 * Vector6d::Unit(i) + Vector6d::Constant(0.05);
    const SE3 difference = (T * SE3::exp(delta)).inverse() * (SE3::exp(vo::adjoint(T) * delta) * T);
    EXPECT_LT(difference.log().norm(), 1e-14) << "component " << i;
  }
}

/// With w = rho'(r) / (2 r) the summed loss has the derivative 2 b.
TEST(JointProblem, RightHandSideIsTheGradientOfTheSummedLoss) {
  const SymmetricPair pair;
  constexpr double kStep = 1e-3;  // m and rad
  for (const RobustLoss loss : {RobustLoss::none, RobustLoss::huber, RobustLoss::student_t}) {
    const vo::AlignOptions options{.loss = loss, .loss_scale = 0.05};
    const vo::JointProblem problem(pair.references, pair.current, 0, options);
    const vo::JointSystem system = problem.linearize(pair.T_cur_first);
    ASSERT_EQ(system.points, system.total) << "all in view";
    ASSERT_EQ(system.parts.size(), 4U);
    for (int i = 0; i < 6; ++i) {
      const SE3 step = SE3::exp(kStep * Vector6d::Unit(i));
      const double slope = (summed_loss(problem.linearize(step * pair.T_cur_first)) -
                            summed_loss(problem.linearize(step.inverse() * pair.T_cur_first))) /
                           (2 * kStep);
      EXPECT_NEAR(slope, 2 * system.b(i), 2e-3 * 2 * system.b.head<6>().norm()) << i;
    }
  }
}

/// After the step that solves the linear equations nothing is left of their right sides.
TEST(JointProblem, GradientsVanishWhereTheSystemsOwnStepLeads) {
  const SymmetricPair pair;
  const vo::AlignOptions options{.loss_scale = 0.05, .brightness = vo::BrightnessModel::affine};
  const vo::JointProblem problem(pair.references, pair.current, 0, options);
  const vo::JointSystem before = problem.linearize(pair.T_cur_first);
  vo::JointSystem after = before;
  problem.advance(after, before.step(), pair.T_cur_first);
  EXPECT_LT(after.b.norm(), 1e-9 * before.b.norm());
  for (std::size_t i = 0; i < after.parts.size(); ++i) {
    EXPECT_LT(after.parts[i].b.tail<2>().norm(), 1e-9 * before.parts[i].b.norm()) << i;
  }
}

/// Derivative of what each point sees, by central differences over the views as written down above.
std::vector<Vector6d> numeric_jacobians(const SymmetricPair& pair, std::size_t view) {
  constexpr double kStep = 1e-3;  // m and rad
  std::vector<Vector6d> J(pair.views(pair.T_cur_first)[view].points.size());
  for (int i = 0; i < 6; ++i) {
    const SE3 step = SE3::exp(kStep * Vector6d::Unit(i));
    const auto after = vo::sampled_intensities(pair.views(step * pair.T_cur_first)[view]);
    const auto before =
        vo::sampled_intensities(pair.views(step.inverse() * pair.T_cur_first)[view]);
    for (std::size_t k = 0; k < J.size(); ++k) {
      J[k](i) = static_cast<double>(after[k] - before[k]) / (2 * kStep);
    }
  }
  return J;
}

TEST(JointProblem, NormalEquationsAreThoseOfNumericJacobians) {
  const SymmetricPair pair;
  const vo::AlignOptions options{.loss = RobustLoss::student_t, .loss_scale = 0.05};
  Matrix6d H = Matrix6d::Zero();
  for (std::size_t view = 0; view < 4; ++view) {
    const vo::EdgePointLevel& points = pair.views(SE3())[view].points;
    const auto seen = vo::sampled_intensities(pair.views(pair.T_cur_first)[view]);
    const auto J = numeric_jacobians(pair, view);
    for (std::size_t k = 0; k < J.size(); ++k) {
      const float residual = seen[k] - points.intensity[k];
      H += vo::robust_value(options.loss, residual, 0.05F).weight / (0.05 * 0.05) * J[k] *
           J[k].transpose();
    }
  }
  const vo::JointProblem problem(pair.references, pair.current, 0, options);
  const Matrix6d expected = problem.linearize(pair.T_cur_first).H;
  for (int p = 0; p < 6; ++p) {
    for (int q = 0; q < 6; ++q) {
      EXPECT_NEAR(H(p, q), expected(p, q), 2e-3 * std::sqrt(expected(p, p) * expected(q, q)))
          << p << " " << q;
    }
  }
}

/// Normal equations of the pose and a gain and an offset for each pair, nothing eliminated.
struct FullSystem {
  Eigen::MatrixXd H;
  Eigen::VectorXd b;

  FullSystem(const SymmetricPair& pair, const vo::JointSystem& system, double scale)
      : H(Eigen::MatrixXd::Zero(14, 14)), b(Eigen::VectorXd::Zero(14)) {
    const SE3 T_cur_second = pair.T_cur_first * pair.T_first_second;
    const std::array<Matrix6d, 4> J{Matrix6d::Identity(), Matrix6d::Identity(),
                                    -vo::adjoint(pair.T_cur_first.inverse()),
                                    -vo::adjoint(T_cur_second.inverse())};
    for (Eigen::Index i = 0; i < 4; ++i) {
      const vo::PointEquations& part = system.parts[static_cast<std::size_t>(i)];
      Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(8, 14);  // d(part's parameters) / d(all)
      moved.topLeftCorner(6, 6) = J[static_cast<std::size_t>(i)];
      moved.block(6, 6 + 2 * i, 2, 2).setIdentity();
      H += moved.transpose() * part.H * moved / (scale * scale);
      b += moved.transpose() * part.b / (scale * scale);
    }
  }
};

TEST(JointProblem, EliminatingBrightnessEqualsSolvingForIt) {
  const SymmetricPair pair;
  const vo::AlignOptions options{
      .loss = RobustLoss::huber, .loss_scale = 0.05, .brightness = vo::BrightnessModel::affine};
  vo::JointProblem problem(pair.references, pair.current, 0, options);
  const vo::JointSystem system = problem.linearize(pair.T_cur_first);
  const FullSystem full(pair, system, options.loss_scale);
  const Eigen::VectorXd expected = -full.H.fullPivLu().solve(full.b);
  const Vector6d delta = -system.H.fullPivLu().solve(system.b);
  EXPECT_LT((delta - expected.head<6>()).norm(), 1e-6 * expected.head<6>().norm());
  problem.update_brightness(system, delta, pair.T_cur_first);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto index = static_cast<Eigen::Index>(6 + 2 * i);
    EXPECT_NEAR(problem.models()[i].brightness.gain - 1, expected(index), 1e-6);
    EXPECT_NEAR(problem.models()[i].brightness.offset, expected(index + 1), 1e-6);
  }
}

/// Normal equations of pose, read-out times along rows and columns, and each pair's gain and
/// offset, from numeric derivatives of what the points see while all cameras move.
class RollingShutter {
 public:
  static constexpr int kPoseParameters = 6;
  static constexpr int kFirstBrightness = 8;
  static constexpr int kParameters = 16;

  RollingShutter() {
    pair.references[0].velocity.twist << 0.3, -0.2, 0.1, 0.2, 0.3, -0.4;
    pair.references[1].velocity.twist << -0.1, 0.4, 0.2, -0.3, 0.1, 0.3;
    const Vector6d velocity = (Vector6d() << 0.2, 0.3, -0.2, 0.4, -0.2, 0.3).finished();
    pair.current.previous = {SE3::exp(velocity / 30) * pair.T_cur_first, 1 / 30.0, {}};
    for (std::size_t view = 0; view < 4; ++view) {
      add(view);
    }
  }

  SymmetricPair pair;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(kParameters, kParameters);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(kParameters);

 private:
  std::vector<float> seen(std::size_t view, const SE3& T_cur_first,
                          const vo::Readout& readout) const {
    const vo::PointView still = pair.views(T_cur_first)[view];
    const vo::ReadoutMotion current(pair.current.velocity(pair.T_cur_first).twist, readout);
    const vo::ReadoutMotion reference(pair.references[view % 2].velocity.twist, readout);
    const bool forward = view < 2;
    return vo::sampled_intensities({still.points, still.image, still.T_cur_ref,
                                    forward ? reference : current, forward ? current : reference});
  }

  /// Returns what the view's points see with one parameter moved by a step.
  std::vector<float> seen_after(std::size_t view, int parameter, double step) const {
    if (parameter < kPoseParameters) {
      return seen(view, SE3::exp(step * Vector6d::Unit(parameter)) * pair.T_cur_first, {});
    }
    return seen(view, pair.T_cur_first,
                {step, static_cast<vo::ReadoutAxis>(parameter - kPoseParameters)});
  }

  void add(std::size_t view) {
    constexpr double kStep = 1e-3;  // m, rad, s
    const std::vector<float> here = seen(view, pair.T_cur_first, {});
    const std::vector<float>& expected = pair.views(SE3())[view].points.intensity;
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(here.size()), kParameters);
    Eigen::VectorXd r(J.rows());
    for (int p = 0; p < kFirstBrightness; ++p) {
      const auto after = seen_after(view, p, kStep);
      const auto before = seen_after(view, p, -kStep);
      for (std::size_t k = 0; k < here.size(); ++k) {
        J(static_cast<Eigen::Index>(k), p) =
            static_cast<double>(after[k] - before[k]) / (2 * kStep);
      }
    }
    const auto gain = static_cast<Eigen::Index>(kFirstBrightness + 2 * view);
    for (std::size_t k = 0; k < here.size(); ++k) {
      r(static_cast<Eigen::Index>(k)) = here[k] - expected[k];
      J(static_cast<Eigen::Index>(k), gain) = -expected[k];
      J(static_cast<Eigen::Index>(k), gain + 1) = -1;
    }
    H += J.transpose() * J;
    b += J.transpose() * r;
    H.diagonal().segment<2>(gain).array() +=
        kBrightnessPrior * static_cast<double>(here.size() + 1);
  }
};

/// All but the read-out times is eliminated; the loss is a sum of squares.
TEST(JointProblem, LossByReadoutIsThatOfNumericJacobians) {
  const RollingShutter numeric;
  for (const vo::BrightnessModel model : {vo::BrightnessModel::same, vo::BrightnessModel::affine}) {
    const vo::AlignOptions options{
        .loss = RobustLoss::none, .loss_scale = 0.05, .brightness = model};
    const vo::JointProblem problem(numeric.pair.references, numeric.pair.current, 0, options);
    const vo::JointSystem system = problem.linearize(numeric.pair.T_cur_first);
    ASSERT_EQ(system.points, system.total) << "all in view";
    vo::AlignMemory memory;
    const vo::LossByReadout found =
        problem.scores(system, numeric.pair.T_cur_first, memory).loss_by_readout;

    const std::vector<int> own{6, 7};
    std::vector<int> others{0, 1, 2, 3, 4, 5};
    for (int p = RollingShutter::kFirstBrightness;
         p < RollingShutter::kParameters && model == vo::BrightnessModel::affine; ++p) {
      others.push_back(p);
    }
    const Eigen::MatrixXd coupling = numeric.H(others, own);
    const Eigen::MatrixXd shares =
        numeric.H(others, others).eval().fullPivLu().solve(coupling).transpose();
    const double factor = 2 / (0.05 * 0.05);
    const Eigen::MatrixXd curvature = factor * (numeric.H(own, own) - shares * coupling);
    const Eigen::VectorXd slope = factor * (numeric.b(own) - shares * numeric.b(others));
    EXPECT_LT((found.curvature - curvature).norm(), 0.01 * curvature.norm());
    EXPECT_LT((found.slope - slope).norm(), 0.01 * slope.norm());
  }
}

/// From 0.1 m/s forward: a tenth of a second earlier the camera was a centimetre behind.
TEST(AlignCurrent, VelocityIsThatFromThePreviousFrame) {
  const SymmetricPair pair;
  const Vector6d velocity = (Vector6d() << 0.1, -0.2, 0.3, 0.4, 0.2, -0.1).finished();
  const SE3 T_first_cur = pair.T_cur_first.inverse();
  const SE3 T_first_last = T_first_cur * SE3::exp(-0.1 * velocity);
  const vo::AlignCurrent current{pair.frame, nullptr,
                                 vo::PreviousFrame{T_first_last.inverse(), 0.1}};
  EXPECT_LT((current.velocity(pair.T_cur_first).twist - velocity).norm(), 1e-12);
  EXPECT_EQ(pair.current.velocity(pair.T_cur_first).twist, Vector6d::Zero());
}

}  // namespace
