#include "vo/alignment/joint_problem.h"

#include <algorithm>

#include "vo/alignment/noise_curvature.h"
#include "vo/core/parallel_for.h"
#include "vo/residuals/rolling_shutter_moments.h"

namespace vo {
namespace {

/// Sets the pixels of a backward pair's points, which are the current frame's own.
void place_at_pixels(const std::vector<cv::Point>& pixels, PointTerms& scores) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    scores.u[i] = static_cast<float>(pixels[i].x);
    scores.v[i] = static_cast<float>(pixels[i].y);
  }
}

/// Sums of weights and of curvatures of the robust loss over points.
struct CurvatureSums {
  double weight = 0;
  double curvature = 0;

  void add(const PointTerms& scores, const AlignOptions& options, double scale) {
    for (std::size_t i = 0; i < scores.weight.size(); ++i) {
      const auto w = static_cast<double>(scores.weight[i]);
      const double share = curvature_share(options.loss, scores.residual[i], scale);
      weight += w;
      curvature += w * (options.squared_weights ? 2 * share - 1 : share);
    }
  }
};

/// Returns the derivatives of the loss, which are twice those of the normal equations. The weights
/// overstate the curvature, which holds the time more firmly.
LossByReadout least_loss(const NormalEquations<2>& readout) {
  return {.slope = 2 * readout.b, .curvature = 2 * readout.H};
}

}  // namespace

FrameVelocity AlignCurrent::velocity(const SE3& T_cur_first) const {
  if (!previous) {
    return {};
  }
  const SE3 T_last_cur = previous->T_last_first * T_cur_first.inverse();
  return velocity_at_end({T_last_cur.log() / previous->seconds_ago, previous->seconds_ago},
                         previous->before);
}

JointProblem::JointProblem(std::span<const AlignReference> references, const AlignCurrent& current,
                           std::size_t level, const AlignOptions& options)
    : current_(current), level_(level), options_(options) {
  for (const AlignReference& reference : references) {
    pairs_.push_back({&reference, /*backward=*/false});
  }
  for (const AlignReference& reference : references) {
    if (reference.frame != nullptr && current.points != nullptr) {
      pairs_.push_back({&reference, /*backward=*/true});
    }
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    models_.push_back({options.loss_scale, {}});
  }
}

/// Calls `body(i)` for each pair, spread over the options' threads.
template <typename Body>
void JointProblem::for_each_pair(const Body& body) const {
  parallel_for(pairs_.size(), options_.threads, body);
}

PointView JointProblem::view(const ImagePair& pair, const SE3& T_cur_first) const {
  const AlignReference& reference = *pair.reference;
  const SE3 T_cur_ref = T_cur_first * reference.T_first_ref;
  const ReadoutMotion ref_motion(reference.velocity.twist, options_.readout);
  const ReadoutMotion cur_motion =
      options_.readout.is_rolling()
          ? ReadoutMotion(current_.velocity(T_cur_first).twist, options_.readout)
          : ReadoutMotion();
  if (pair.backward) {
    return {current_.points->levels[level_], reference.frame->levels[level_], T_cur_ref.inverse(),
            cur_motion, ref_motion};
  }
  return {reference.points.levels[level_], current_.frame.levels[level_], T_cur_ref, ref_motion,
          cur_motion};
}

PointView JointProblem::forward_view(std::size_t reference, const SE3& T_cur_first) const {
  return view(pairs_[reference], T_cur_first);
}

/// Returns d(left increment of the pair's transform) / d(left increment of T_cur_first). A backward
/// pair's transform is the inverse: exp(-delta) on its right.
Matrix6d JointProblem::increment_jacobian(const ImagePair& pair, const SE3& T_cur_first) const {
  if (!pair.backward) {
    return Matrix6d::Identity();
  }
  return -adjoint((T_cur_first * pair.reference->T_first_ref).inverse());
}

/// Returns the equations of the pose alone, with the brightness eliminated where it is estimated.
NormalEquations<6> JointProblem::of_pose(const PointEquations& equations) const {
  return options_.brightness == BrightnessModel::affine
             ? equations.eliminated<kBrightnessParameters>()
             : equations.leading<kPoseParameters>();
}

void JointProblem::add_part(std::size_t pair, const SE3& T_cur_first, JointSystem& system) const {
  const PointEquations& part = system.parts[pair];
  const double inverse_variance = 1 / (models_[pair].scale * models_[pair].scale);
  system.add(of_pose(part), increment_jacobian(pairs_[pair], T_cur_first), inverse_variance);
  system.points += part.points;
  system.total += part.total;
}

/// Returns the reference's index; the pairs point into one contiguous array of references.
std::size_t JointProblem::index_of(const ImagePair& pair) const {
  return static_cast<std::size_t>(pair.reference - &first());
}

/// Returns the view of the first reference's surfaces in the current depth image.
DepthView JointProblem::depth_view(const SE3& T_cur_first) const {
  return {*first().surface, current_.frame.levels[surface_level(current_.frame)],
          T_cur_first * first().T_first_ref};
}

double JointProblem::depth_agreement(const SE3& T_cur_first) const {
  return first().surface != nullptr ? vo::depth_agreement(depth_view(T_cur_first)) : 1;
}

double JointProblem::depth_weight() const {
  return options_.depth_term / (distance_scale_ * distance_scale_);
}

void JointProblem::add_depth(const SE3& T_cur_first, JointSystem& system) const {
  if (distance_scale_ > 0) {
    system.add(linearize_depth(depth_view(T_cur_first), distance_scale_), depth_weight());
  }
}

/// Adds the surface points' terms of b by cell, with pixels scaled from their level to this one.
void JointProblem::add_depth(const SE3& T_cur_first, AlignMemory& memory) const {
  if (!(distance_scale_ > 0)) {
    return;
  }
  const DepthView view = depth_view(T_cur_first);
  const double pixels = static_cast<double>(camera().width) / view.image.camera.width;
  score_depth(view, distance_scale_, memory.depth_scores);
  for (const DepthScore& score : memory.depth_scores) {
    memory.scores.references.front().add(static_cast<float>(pixels * score.pixel.x()),
                                         static_cast<float>(pixels * score.pixel.y()),
                                         depth_weight() * score.b);
  }
}

JointSystem JointProblem::linearize(const SE3& T_cur_first) const {
  JointSystem system;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    system.parts.emplace_back();
  }
  for_each_pair([&](std::size_t i) {
    system.parts[i] = vo::linearize(view(pairs_[i], T_cur_first), options_, models_[i]);
  });
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    add_part(i, T_cur_first, system);
  }
  add_depth(T_cur_first, system);
  system.cost /= static_cast<double>(std::max<std::size_t>(system.total, 1));
  return system;
}

CellScores::Projection JointProblem::projection(std::size_t pair, const PointEquations& part,
                                                const SE3& T_cur_first) const {
  CellScores::Projection eliminated = CellScores::Projection::Zero();
  eliminated.leftCols<6>().setIdentity();
  if (options_.brightness == BrightnessModel::affine) {
    eliminated.rightCols<2>() =
        -part.solve_trailing<2>(part.H.bottomLeftCorner<2, 6>()).transpose();
  }
  const Matrix6d J = increment_jacobian(pairs_[pair], T_cur_first);
  return J.transpose() * eliminated / (models_[pair].scale * models_[pair].scale);
}

JointProblem::ScoredPair JointProblem::scored(std::size_t pair, const PointEquations& part,
                                              const SE3& T_cur_first, PointTerms& scores) const {
  const PointView seen = view(pairs_[pair], T_cur_first);
  const ResidualModel& model = models_[pair];
  compute_point_terms(seen, options_, model, scores);
  return {.pair = pairs_[pair],
          .part = part,
          .seen = seen,
          .scores = scores,
          .to_pose = projection(pair, part, T_cur_first),
          .inverse_variance = 1 / (model.scale * model.scale)};
}

/// Adds the curvature that the noise of a pair's images adds to the system's H, where it is known:
/// other formulations than ESM look at the gradients of one image alone.
void JointProblem::add_noise(const ScoredPair& scored, const SE3& T_cur_first,
                             JointScores& result) const {
  if (options_.formulation != Formulation::esm) {
    return;
  }
  PointEquations noise = noise_equations(scored.seen, scored.scores);
  noise.H.bottomRightCorner<kBrightnessParameters, kBrightnessParameters>() =
      scored.part.H.bottomRightCorner<kBrightnessParameters, kBrightnessParameters>();
  const Matrix6d J = increment_jacobian(scored.pair, T_cur_first);
  result.noise_curvature += scored.inverse_variance * J.transpose() * of_pose(noise).H * J;
}

/// Adds the derivatives of b by the velocities, to first order with the points' weights fixed.
void JointProblem::add_velocities(const ScoredPair& scored, JointScores& result) const {
  if (!options_.readout.is_rolling()) {
    return;
  }
  const double seconds = options_.readout.seconds;
  const RollingShutterMoments moments =
      RollingShutterMoments::of(scored.seen, scored.scores, options_.readout.axis);
  const Matrix6d by_points =
      seconds * scored.to_pose * moments.points * adjoint(scored.seen.T_cur_ref);
  const Matrix6d by_image = -seconds * scored.to_pose * moments.image;
  result.by_current_velocity += scored.pair.backward ? by_points : by_image;
  result.by_reference_velocity[index_of(scored.pair)] +=
      scored.pair.backward ? by_image : by_points;
}

/// Adds a pair's derivatives by the read-out times to first order, its brightness eliminated.
void JointProblem::add_readout(const ScoredPair& scored, const SE3& T_cur_first,
                               ReadoutEquations& equations) const {
  const Vector6d current = current_.velocity(T_cur_first).twist;
  const Vector6d& reference = scored.pair.reference->velocity.twist;
  const Vector6d& of_points = scored.pair.backward ? current : reference;
  const Vector6d& of_image = scored.pair.backward ? reference : current;
  const ReadoutMoments moments = ReadoutMoments::of(
      scored.seen, scored.scores, adjoint(scored.seen.T_cur_ref) * of_points, of_image);
  const Eigen::Matrix2d by_brightness = moments.coupling.bottomRows<2>();
  Eigen::Matrix2d eliminated = Eigen::Matrix2d::Zero();
  if (options_.brightness == BrightnessModel::affine) {
    eliminated = scored.part.solve_trailing<2>(by_brightness);
  }
  equations.H.topLeftCorner<2, 2>() +=
      scored.inverse_variance * (moments.square - eliminated.transpose() * by_brightness);
  equations.b.head<2>() += scored.inverse_variance *
                           (moments.by_residual - eliminated.transpose() * scored.part.b.tail<2>());
  const Eigen::Matrix<double, 6, 2> coupling = scored.to_pose * moments.coupling;
  equations.H.bottomLeftCorner<6, 2>() += coupling;
  equations.H.topRightCorner<2, 6>() += coupling.transpose();
}

void JointScores::reset(std::size_t reference_count, const PinholeCamera& camera) {
  if (references.size() < reference_count) {
    references.resize(reference_count);
  }
  for (CellScores& reference : references) {
    reference.reset(camera);
  }
  noise_curvature.setZero();
  by_current_velocity.setZero();
  by_reference_velocity.clear();
  for (std::size_t r = 0; r < reference_count; ++r) {
    by_reference_velocity.push_back(Matrix6d::Zero());
  }
}

const JointScores& JointProblem::scores(const JointSystem& system, const SE3& T_cur_first,
                                        AlignMemory& memory) const {
  JointScores& result = memory.scores;
  result.reset(index_of(pairs_.back()) + 1, camera());
  CurvatureSums sums;
  ReadoutEquations readout;
  readout.H.bottomRightCorner<6, 6>() = system.H;
  readout.b.tail<6>() = system.b;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const ScoredPair pair = scored(i, system.parts[i], T_cur_first, memory.terms);
    add_noise(pair, T_cur_first, result);
    add_velocities(pair, result);
    add_readout(pair, T_cur_first, readout);
    if (i == 0) {
      result.agreement = view_agreement(pair.seen, pair.scores, models_.front());
    }
    if (pair.pair.backward) {
      place_at_pixels(pair.seen.points.pixel, pair.scores);
    }
    sums.add(pair.scores, options_, models_[i].scale);
    result.references[index_of(pair.pair)].add(pair.scores, pair.to_pose);
  }
  add_depth(T_cur_first, memory);
  result.curvature_share = sums.curvature / sums.weight;
  result.loss_by_readout = least_loss(readout.eliminated<6>());
  return result;
}

void JointProblem::estimate_scales(const SE3& T_cur_first) {
  constexpr double kMinDistanceScale = 5e-4;  // m
  if (options_.depth_term > 0 && first().surface != nullptr) {
    const double spread = distance_spread(depth_view(T_cur_first));
    distance_scale_ = spread > 0 ? std::max(spread, kMinDistanceScale) : 0;
  }
  if (options_.scale == LossScale::fixed) {
    return;
  }
  for_each_pair([&](std::size_t i) {
    models_[i].scale = shown_scale(view(pairs_[i], T_cur_first), models_[i].brightness, options_);
  });
}

void JointProblem::match_brightness(const SE3& T_cur_first) {
  if (options_.brightness == BrightnessModel::same) {
    return;
  }
  for_each_pair([&](std::size_t i) {
    models_[i].brightness = matched_brightness(view(pairs_[i], T_cur_first));
  });
}

void JointProblem::start_from(const JointProblem& coarser, const SE3& T_cur_first) {
  if (options_.brightness == BrightnessModel::same) {
    return;
  }
  for_each_pair([&](std::size_t i) {
    const auto* same = std::find(coarser.pairs_.begin(), coarser.pairs_.end(), pairs_[i]);
    models_[i].brightness =
        same != coarser.pairs_.end()
            ? coarser.models_[static_cast<std::size_t>(same - coarser.pairs_.begin())].brightness
            : matched_brightness(view(pairs_[i], T_cur_first));
  });
}

/// Returns the increment of a pair's pose, gain and offset that goes with one of the system.
PointEquations::Vector JointProblem::part_step(const JointSystem& system, std::size_t pair,
                                               const Vector6d& delta,
                                               const SE3& T_cur_first) const {
  PointEquations::Vector step = PointEquations::Vector::Zero();
  const Vector6d pose = increment_jacobian(pairs_[pair], T_cur_first) * delta;
  step.head<kPoseParameters>() = pose;
  if (options_.brightness == BrightnessModel::affine) {
    step.tail<kBrightnessParameters>() =
        system.parts[pair].eliminated_step<kBrightnessParameters>(pose);
  }
  return step;
}

void JointProblem::update_brightness(const JointSystem& system, const Vector6d& delta,
                                     const SE3& T_cur_first) {
  if (options_.brightness == BrightnessModel::same) {
    return;
  }
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const PointEquations::Vector step = part_step(system, i, delta, T_cur_first);
    models_[i].brightness.gain += step[kPoseParameters];
    models_[i].brightness.offset += step[kPoseParameters + 1];
  }
}

void JointProblem::advance(JointSystem& system, const Vector6d& delta,
                           const SE3& T_cur_first) const {
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    PointEquations& part = system.parts[i];
    part.b += part.H * part_step(system, i, delta, T_cur_first);
  }
  system.b.setZero();
}

}  // namespace vo
