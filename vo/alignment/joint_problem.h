#pragma once

#include <optional>
#include <span>
#include <vector>

#include "vo/alignment/align_result.h"
#include "vo/core/inplace_vector.h"
#include "vo/core/normal_equations.h"
#include "vo/residuals/cell_scores.h"
#include "vo/residuals/depth_term.h"
#include "vo/residuals/frame_velocity.h"
#include "vo/residuals/linearize.h"
#include "vo/residuals/view_agreement.h"

namespace vo {

/// A frame of known pose that the current one is aligned to.
struct AlignReference {
  const EdgePoints& points;
  SE3 T_first_ref;                      ///< transform to the first reference's frame
  const FramePyramid* frame = nullptr;  ///< image that current points are looked up in, if any
  FrameVelocity velocity;
  const SurfacePoints* surface = nullptr;  ///< surface points of its depth image, if compared
  Vignette vignette = {};                  ///< vignette removed from its intensities
};

/// The camera's pose one frame earlier, from which the velocity follows for any current pose.
struct PreviousFrame {
  SE3 T_last_first;  ///< first: the first reference
  double seconds_ago = 0;
  std::optional<MeanVelocity> before;  ///< mean velocity before that frame
};

/// The frame whose pose is sought.
struct AlignCurrent {
  const FramePyramid& frame;
  const EdgePoints* points = nullptr;     ///< own edge points, if looked up in references
  std::optional<PreviousFrame> previous;  ///< for a rolling shutter

  /// Returns the velocity at the current frame, or 0 if the previous pose is not known.
  FrameVelocity velocity(const SE3& T_cur_first) const;
};

/// The normal equations of one left increment of T_cur_first, summed over pairs of images with each
/// pair's brightness eliminated. Each pair counts in squares of its own scale. The cost is the loss
/// per point.
struct JointSystem : NormalEquations<6> {
  std::size_t points = 0;  ///< number of seen points
  std::size_t total = 0;   ///< number of points, seen or not
  InplaceVector<PointEquations, kMaxPairs>
      parts;  ///< one for each pair: references forward, then backward
};

/// The points' contributions to the system's b, by the reference and the cell of the current image.
struct JointScores {
  /// Scores of each reference. There may be more than references, to keep memory: those are 0.
  std::vector<CellScores> references;
  double curvature_share = 1;  ///< mean curvature of the loss over the mean weight

  /// Derivative of b by the current frame's velocity; 0 without a rolling shutter.
  Matrix6d by_current_velocity = Matrix6d::Zero();
  InplaceVector<Matrix6d, kMaxReferences> by_reference_velocity;

  Matrix6d noise_curvature = Matrix6d::Zero();  ///< noise's part of the system's H
  LossByReadout loss_by_readout;                ///< first-order in the residuals
  ViewAgreement agreement;  ///< of the first reference's points with the current image

  /// Starts anew with this many references, and images of this camera.
  void reset(std::size_t reference_count, const PinholeCamera& camera);
};

/// Memory that alignments work in. Who aligns frame after frame keeps it, so that nothing is
/// allocated once it is large enough.
struct AlignMemory {
  JointScores scores;
  PointTerms terms;                      ///< of the pair of images that is being scored
  std::vector<DepthScore> depth_scores;  ///< of the first reference's surface points
};

/// The current frame and all its references at one pyramid level: the references' points looked up
/// in the current image and the current frame's points looked up in the references.
class JointProblem {
 public:
  /// The arguments must outlive the problem.
  JointProblem(std::span<const AlignReference> references, const AlignCurrent& current,
               std::size_t level, const AlignOptions& options);

  JointSystem linearize(const SE3& T_cur_first) const;

  /// Splits the system's b, linearized at this pose, by reference and cell. The result lives in the
  /// memory, until it is used again.
  const JointScores& scores(const JointSystem& system, const SE3& T_cur_first,
                            AlignMemory& memory) const;

  /// Returns the view of a reference's points in the current image; `models` has it at this index.
  PointView forward_view(std::size_t reference, const SE3& T_cur_first) const;

  /// Returns the view of a pair of images, in the order of `models`: each reference's points in the
  /// current image, then the current points in each reference's image.
  PointView pair_view(std::size_t pair, const SE3& T_cur_first) const {
    return view(pairs_[pair], T_cur_first);
  }

  /// Returns vo::depth_agreement() of the first reference's surfaces, or 1 without surfaces.
  double depth_agreement(const SE3& T_cur_first) const;

  /// Estimates the robust loss's scale of each pair at this pose if LossScale::residuals is set,
  /// and the scale of the surface distances.
  void estimate_scales(const SE3& T_cur_first);
  /// Sets each pair's gain and offset from the intensities' means and spreads at this pose.
  void match_brightness(const SE3& T_cur_first);

  /// Starts from the brightness found on a coarser level; pairs that were not aligned there start
  /// from the intensities' means and spreads at this pose.
  void start_from(const JointProblem& coarser, const SE3& T_cur_first);

  /// Moves each pair's brightness along with a pose increment of the system.
  void update_brightness(const JointSystem& system, const Vector6d& delta, const SE3& T_cur_first);

  /// Moves the gradients of the system's parts along with the pose increment that solves it and the
  /// steps of brightness that go with it, to first order. That of the system becomes 0.
  void advance(JointSystem& system, const Vector6d& delta, const SE3& T_cur_first) const;

  using Models = InplaceVector<ResidualModel, kMaxPairs>;

  const Models& models() const { return models_; }
  void set_models(const Models& models) { models_ = models; }
  const FrameVelocity& reference_velocity(std::size_t reference) const {
    return pairs_[reference].reference->velocity;
  }
  FrameVelocity current_velocity(const SE3& T_cur_first) const {
    return current_.velocity(T_cur_first);
  }
  const AlignOptions& options() const { return options_; }
  std::size_t level() const { return level_; }
  const PinholeCamera& camera() const { return current_.frame.levels[level_].camera; }

 private:
  /// A frame's points looked up in the image of another frame.
  struct ImagePair {
    const AlignReference* reference;
    bool backward;  ///< the points are the current frame's and the image is the reference's

    bool operator==(const ImagePair&) const = default;
  };

  /// The unknowns are the read-out times along both axes and the increment of the pose.
  using ReadoutEquations = NormalEquations<8>;

  /// The terms of an image pair's points and the projection of their b to that of the pose.
  struct ScoredPair {
    const ImagePair& pair;
    const PointEquations& part;
    PointView seen;
    PointTerms& scores;
    CellScores::Projection to_pose;
    double inverse_variance;  ///< of the residuals, 1 / intensity^2
  };

  PointView view(const ImagePair& pair, const SE3& T_cur_first) const;
  Matrix6d increment_jacobian(const ImagePair& pair, const SE3& T_cur_first) const;
  PointEquations::Vector part_step(const JointSystem& system, std::size_t pair,
                                   const Vector6d& delta, const SE3& T_cur_first) const;
  NormalEquations<6> of_pose(const PointEquations& equations) const;
  void add_part(std::size_t pair, const SE3& T_cur_first, JointSystem& system) const;
  const AlignReference& first() const { return *pairs_.front().reference; }
  std::size_t index_of(const ImagePair& pair) const;
  template <typename Body>
  void for_each_pair(const Body& body) const;
  DepthView depth_view(const SE3& T_cur_first) const;
  double depth_weight() const;
  void add_depth(const SE3& T_cur_first, JointSystem& system) const;
  void add_depth(const SE3& T_cur_first, AlignMemory& memory) const;
  ScoredPair scored(std::size_t pair, const PointEquations& part, const SE3& T_cur_first,
                    PointTerms& scores) const;
  void add_noise(const ScoredPair& scored, const SE3& T_cur_first, JointScores& result) const;
  void add_velocities(const ScoredPair& scored, JointScores& result) const;
  void add_readout(const ScoredPair& scored, const SE3& T_cur_first,
                   ReadoutEquations& equations) const;
  CellScores::Projection projection(std::size_t pair, const PointEquations& part,
                                    const SE3& T_cur_first) const;

  const AlignCurrent& current_;
  std::size_t level_;
  const AlignOptions& options_;
  InplaceVector<ImagePair, kMaxPairs> pairs_;
  Models models_;
  double distance_scale_ = 0;  ///< m, scale of the distances from the first reference's surfaces
};

}  // namespace vo
