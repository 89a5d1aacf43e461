#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "vo/residuals/linearize.h"

namespace vo {

/// Normal equations of one frame's points, looked up in the images of several others: increments of
/// the pairs' transforms [pair by pair, left of T_target_host], then gain and offset of each pair,
/// and the points' inverse depths, 1/m, which belong to all pairs. Each pair counts in squares of
/// its own scale.
class HostSystem {
 public:
  /// Of at least one pair, with inverse depths if `points` is not 0. The options must outlive the
  /// system.
  HostSystem(const AlignOptions& options, std::size_t pairs, std::size_t points);

  /// `view` is the k-th pair's.
  void add(std::size_t k, const PointView& view, const ResidualModel& model);

  /// The cost of `information` (1/variance, m^2) times the square of `strayed` (1/m) for each
  /// point's inverse depth; to be called once, after all pairs. Eliminates the depths (Schur
  /// complement).
  void hold_depth(const Eigen::VectorXd& information, const Eigen::VectorXd& strayed);

  /// Of the pairs' increments, all else eliminated.
  struct Increments {
    Eigen::MatrixXd H;
    Eigen::VectorXd b;
  };
  Increments increments() const;

  /// What goes with a step of the increments.
  struct Step {
    Eigen::VectorXd brightness;     ///< gain and offset, pair by pair
    Eigen::VectorXd inverse_depth;  ///< 1/m; of no points if they are not adjusted
  };
  Step step_with(const Eigen::VectorXd& increments) const;

 private:
  void add_depth(std::size_t k, const PointView& view, double scale);  ///< of points with scores
  Eigen::Index poses() const { return 6 * pairs_; }
  Eigen::Index brightness() const { return 2 * pairs_; }
  Eigen::MatrixXd brightness_gain() const;  ///< d brightness / d increments

  const AlignOptions& options_;
  Eigen::Index pairs_;
  Eigen::MatrixXd H_pairs_;
  Eigen::VectorXd b_pairs_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
      coupling_;  ///< of all else with inverse depths; a column for each point
  Eigen::VectorXd H_depth_;
  Eigen::VectorXd b_depth_;
  PointTerms scores_;  ///< of the pair that is added
};

}  // namespace vo
