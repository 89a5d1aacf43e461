#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vo/core/instruction_set.h"
#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/robust.h"
#include "vo/residuals/row_motion.h"

namespace vo {

/// Everything a pass over the points of one level needs beside the points.
struct PassOptions {
  RobustLoss loss = RobustLoss::huber;
  float loss_scale = 0;  ///< intensity
  bool squared_weights = false;
  float gain = 1;              ///< I_cur is compared with gain I_ref + offset
  float offset = 0;            ///< intensity
  float current_share = 1;     ///< of the current image's gradient in the Jacobian: 1 forward
  float reference_share = 0;   ///< of the reference's: 1 inverse, 0.5 and 0.5 ESM
  float inverse_variance = 0;  ///< 1 / intensity^2, turns on weights by depth uncertainty
  float max_depth_ratio = 0;   ///< the z-test: points this much behind or before the current
                               ///< surface are not seen; 0 is off
  bool brightness = false;     ///< whether to sum the columns of gain and offset
};

constexpr std::size_t kPoseParameters = 6;
constexpr std::size_t kPassParameters = 8;  ///< pose increment, gain, offset
constexpr std::size_t kPassPairs = kPassParameters * (kPassParameters + 1) / 2;

/// Normal equations of the increment [translation; rotation; gain; offset], left of T_cur_ref.
struct PassSums {
  std::array<double, kPassPairs> H{};  ///< upper triangle, row by row
  std::array<double, kPassParameters> b{};
  double loss = 0;
  std::size_t seen = 0;

  Eigen::Matrix<double, kPassParameters, kPassParameters> matrix() const;  ///< H
  Eigen::Matrix<double, kPassParameters, 1> right_side() const;            ///< b
};

/// What each point adds to the normal equations, one element per point in each array: to b, w r J.
/// Where it is not seen its weight is 0.
struct PointTerms {
  std::array<std::vector<float>, kPassParameters> J;
  std::vector<float> weight;
  std::vector<float> residual;  ///< intensity
  std::vector<float> u;         ///< px, in the image
  std::vector<float> v;         ///< px

  void resize(std::size_t points);
};

/// Points of one frame and the image of another that they are looked up in.
struct PointView {
  const EdgePointLevel& points;
  const PyramidLevel& image;
  SE3 T_cur_ref;  ///< ref: the points' frame, cur: the image's
  RowMotion points_motion;
  RowMotion image_motion;
};

/// r = I_cur(pi(T_cur_ref p_ref)) - gain I_ref - offset over all points that are seen.
PassSums sum_points(const PointView& view, const PassOptions& options, InstructionSet set);

/// The terms of the sums' b, point by point; `scores` are overwritten.
void compute_point_terms(const PointView& view, const PassOptions& options, InstructionSet set,
                         PointTerms& scores);

/// The image's intensity at each point, NaN where the point is not seen. With a stride, only every
/// so many groups of 64 neighbouring points are looked up, and the others are NaN.
void sample_points(const PointView& view, std::size_t stride, InstructionSet set,
                   std::vector<float>& intensities);

}  // namespace vo
