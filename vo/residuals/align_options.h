#pragma once

#include <array>
#include <utility>

#include "vo/geometry/readout.h"
#include "vo/residuals/robust.h"

namespace vo {

/// Source of the Jacobian's gradient (Baker & Matthews, "Lucas-Kanade 20 Years On", IJCV 2004;
/// Malis, "Improving vision-based control using efficient second-order minimization", ICRA 2004).
enum class Formulation {
  forward,  ///< the current image's gradient at the warped point: the paper, Eq. 12
  inverse,  ///< the reference image's gradient at the point
  esm,      ///< the mean of both gradients
};

constexpr auto enum_names(Formulation) {
  return std::array{std::pair{Formulation::forward, "forward"},
                    std::pair{Formulation::inverse, "inverse"}, std::pair{Formulation::esm, "esm"}};
}

/// The source of the robust loss's scale.
enum class LossScale {
  fixed,      ///< the given `loss_scale`
  residuals,  ///< from the median |r| of each pair of images at each level
};

constexpr auto enum_names(LossScale) {
  return std::array{std::pair{LossScale::fixed, "fixed"},
                    std::pair{LossScale::residuals, "residuals"}};
}

/// The difference in brightness that two images may have.
enum class BrightnessModel {
  same,    ///< the brightness does not differ
  affine,  ///< a gain and an offset are estimated with the pose
};

constexpr auto enum_names(BrightnessModel) {
  return std::array{std::pair{BrightnessModel::same, "same"},
                    std::pair{BrightnessModel::affine, "affine"}};
}

/// The ratio of a point's depth to the one measured where it is seen from which on it is another
/// surface's.
inline constexpr double kVisibleDepthRatio = 1.08;

struct AlignOptions {
  int max_iterations = 30;         ///< most iterations per pyramid level
  double min_translation = 1e-5;   ///< m; converged when a step is below this and min_rotation_deg
  double min_rotation_deg = 5e-4;  ///< deg; converged when a step is below this and min_translation
  double step_limit_growth = 1;    ///< factor of both step limits per coarser level
  bool keep_worse_step = false;    ///< whether a step that raised the cost is kept
  double last_step = 1;  ///< a step below this many times its limits is taken unchecked, as the
                         ///< last; 1 is none
  bool secant = false;   ///< whether the finest level's steps use the curvature that they showed
  int coarse_references = 0;  ///< most references on levels coarser than the finest; 0 is all
  Formulation formulation = Formulation::forward;
  RobustLoss loss = RobustLoss::huber;
  LossScale scale = LossScale::fixed;
  double loss_scale = 5.0 / 255;  ///< intensity, for `fixed`; five grey levels as in the paper
  bool squared_weights = false;   ///< whether weights enter squared (paper's authors)
  BrightnessModel brightness = BrightnessModel::same;
  double depth_noise = 0;      ///< factor of the points' depth_sigma in the weights; 0 is off
  Readout readout;             ///< rolling shutter's read-out
  double max_depth_ratio = 0;  ///< most ratio of point to measured depth; 0 is no z-test
  double depth_term = 0;       ///< weight of the point-to-plane distances; 0 is off
  int min_points = 100;        ///< least number of visible points of a fit
  int threads = 1;             ///< threads that pairs of images are spread over; same bits

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, AlignOptions& options) {
  visit("max_iterations", options.max_iterations, "per pyramid level");
  visit("min_translation", options.min_translation, "a smaller step is not taken: converged, m");
  visit("min_rotation_deg", options.min_rotation_deg,
        "a smaller step is not taken: converged, deg");
  visit("step_limit_growth", options.step_limit_growth,
        "factor of both limits with each coarser level");
  visit("keep_worse_step", options.keep_worse_step,
        "whether a step that raised the cost is kept, as the paper's authors do");
  visit("last_step", options.last_step,
        "a step below this many times its limits is the last and taken without a look at its cost; "
        "1 is none");
  visit("secant", options.secant,
        "whether steps of the finest level use the curvature of the loss that those before showed");
  visit("coarse_references", options.coarse_references,
        "most references on levels coarser than the finest; 0 is all");
  visit("formulation", options.formulation, "whose gradient the Jacobian is made of");
  visit("loss", options.loss, "robust loss of a residual");
  visit("scale", options.scale, "where the scale of the robust loss comes from");
  visit("loss_scale", options.loss_scale, "of the robust loss, intensity 0..1 (fixed)");
  visit("squared_weights", options.squared_weights,
        "whether weights enter squared, as the paper's authors have it");
  visit("brightness", options.brightness, "how the brightness of two images may differ");
  visit("depth_noise", options.depth_noise,
        "times the depth camera's noise, in the weights; 0 is off");
  visit("readout", options.readout.seconds,
        "time from the first to the last line, s, negative where the last is read first: a rolling "
        "shutter");
  visit("readout_axis", options.readout.axis, "which lines a rolling shutter reads");
  visit("max_depth_ratio", options.max_depth_ratio,
        "points whose depth differs more from the current depth image are not used; 0 is off");
  visit("depth_term", options.depth_term,
        "weight of the distances from the first reference's surfaces; 0 is off");
  visit("min_points", options.min_points, "fewer visible points are not a fit");
  visit("threads", options.threads, "threads that pairs of images are spread over; same bits");
}

}  // namespace vo
