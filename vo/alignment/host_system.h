#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "vo/core/normal_equations.h"
#include "vo/residuals/linearize.h"

namespace vo {

/// The normal equations of one host frame's points looked up in the images of several targets. The
/// unknowns are each pair's increment left of T_target_host, each pair's gain and offset, and the
/// points' inverse depths, 1/m, shared by all pairs. Each pair counts in squares of its own scale.
class HostSystem {
 public:
  /// Creates the empty system of at least one pair, with inverse depths if `points` is not 0. The
  /// options must outlive the system.
  HostSystem(const AlignOptions& options, std::size_t pairs, std::size_t points);

  /// Adds the k-th pair, whose points are looked up as `view` says.
  void add(std::size_t k, const PointView& view, const ResidualModel& model);

  /// Adds the cost `information` (1/variance, m^2) times the square of `strayed` (1/m, distance
  /// from the prior) of each inverse depth, and eliminates the depths (Schur complement). It must
  /// be called once, after all pairs have been added.
  void hold_depth(const Eigen::VectorXd& information, const Eigen::VectorXd& strayed);

  /// Returns the normal equations of the pairs' increments, all other unknowns eliminated.
  NormalEquations<Eigen::Dynamic> increments() const;

  /// The steps of the eliminated unknowns that go with a step of the increments.
  struct Step {
    Eigen::VectorXd brightness;     ///< gain and offset, pair by pair
    Eigen::VectorXd inverse_depth;  ///< 1/m; empty if depths are not adjusted
  };
  Step step_with(const Eigen::VectorXd& increments) const;

 private:
  void add_depth(std::size_t k, const PointView& view, double scale);  ///< uses scores_ of pair k
  Eigen::Index poses() const { return 6 * pairs_; }
  Eigen::Index brightness() const { return 2 * pairs_; }
  Eigen::MatrixXd brightness_gain() const;  ///< d brightness / d increments

  const AlignOptions& options_;
  Eigen::Index pairs_;
  NormalEquations<Eigen::Dynamic> equations_;  ///< of increments, then of gains and offsets
  SeparateUnknowns<Eigen::RowMajor> depths_;   ///< inverse depths
  PointTerms scores_;                          ///< point terms of the pair that is being added
};

}  // namespace vo
