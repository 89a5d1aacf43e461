#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "vo/core/instruction_set.h"
#include "vo/core/normal_equations.h"
#include "vo/geometry/readout.h"
#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/robust.h"

namespace vo {

/// The options of a pass over the points of one level.
struct PassOptions {
  RobustLoss loss = RobustLoss::huber;
  float loss_scale = 0;  ///< scale of the robust loss, intensity
  bool squared_weights = false;
  float gain = 1;              ///< I_cur is compared with gain I_ref + offset
  float offset = 0;            ///< intensity
  float current_share = 1;     ///< share of the current gradient in the Jacobian: 1 forward
  float reference_share = 0;   ///< share of the reference's gradient: 1 inverse; both 0.5 for ESM
  float inverse_variance = 0;  ///< 1 / intensity^2, turns on weights by depth uncertainty; 0 is off
  float max_depth_ratio = 0;   ///< points whose depth differs from the current depth image by more
                               ///< than this ratio are unseen; 0 is off
  bool brightness = false;     ///< whether to sum the columns of gain and offset
};

constexpr std::size_t kPoseParameters = 6;
constexpr std::size_t kBrightnessParameters = 2;
constexpr std::size_t kPassParameters = kPoseParameters + kBrightnessParameters;

/// The normal equations of the increment [translation; rotation; gain; offset], left of T_cur_ref,
/// summed over points. An unseen point adds to the cost only, as much as a residual of the scale.
struct PointEquations : NormalEquations<kPassParameters> {
  std::size_t points = 0;  ///< number of points that are seen
  std::size_t total = 0;   ///< number of points, seen or not

  /// Sets the total and adds the cost of the points that are not seen.
  void complete(std::size_t all_points, const PassOptions& options);
};

/// Each point's terms of the normal equations, one element per point in each array; its term of b
/// is w r J. A point that is not seen has weight 0.
struct PointTerms {
  std::array<std::vector<float>, kPassParameters> J;
  std::vector<float> weight;
  std::vector<float> residual;  ///< intensity
  std::vector<float> u;         ///< px, in the image where the point is looked up
  std::vector<float> v;         ///< px, in the image where the point is looked up

  void resize(std::size_t points);
};

/// The points of one frame and the image of another that they are looked up in.
struct PointView {
  const EdgePointLevel& points;
  const PyramidLevel& image;
  SE3 T_cur_ref;                ///< ref: the points' frame, cur: the image's frame
  ReadoutMotion points_motion;  ///< motion while the points' frame was read
  ReadoutMotion image_motion;   ///< motion while the image was read
};

/// Sums the normal equations of r = I_cur(pi(T_cur_ref p_ref)) - gain I_ref - offset over all seen
/// points.
PointEquations sum_points(const PointView& view, const PassOptions& options, InstructionSet set);

/// Computes the points' terms of the normal equations; `scores` are overwritten.
void compute_point_terms(const PointView& view, const PassOptions& options, InstructionSet set,
                         PointTerms& scores);

}  // namespace vo
