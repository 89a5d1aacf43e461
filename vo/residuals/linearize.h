#pragma once

#include <optional>
#include <vector>

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/align_options.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// The brightness change between two images: I_cur is compared with gain I_ref + offset.
struct Brightness {
  double gain = 1;
  double offset = 0;  ///< intensity
};

/// The robust loss's scale and the brightness change of one pair of images.
struct ResidualModel {
  double scale = 0;  ///< scale of the robust loss, intensity
  Brightness brightness;
};

/// Linearizes the residuals r = I_cur(pi(T_cur_ref p_ref)) - gain I_ref - offset (paper, Eq. 6) in
/// one pass over the points, with the Jacobian of the options' formulation (forward: Eq. 12). A
/// weak prior keeps gain and offset where they are, so that they can be eliminated even where the
/// images have no contrast.
PointEquations linearize(const PointView& view, const AlignOptions& options,
                         const ResidualModel& model);

/// Computes each point's terms of the normal equations; `scores` are overwritten.
void compute_point_terms(const PointView& view, const AlignOptions& options,
                         const ResidualModel& model, PointTerms& scores);

/// Returns the image's intensity at each point, NaN where the point is not seen.
std::vector<float> sampled_intensities(const PointView& view);

/// Returns the residual of each point, or nothing where it is not seen. For pictures and tests.
std::vector<std::optional<float>> residuals(const EdgePointLevel& reference,
                                            const PyramidLevel& current, const SE3& T_cur_ref);

/// Returns Pearson's correlation of the intensities of points and image where they are seen, in
/// [-1, 1], or 0 without contrast. Whatever the contrast, it is near 1 where the images were
/// brought to agree and near 0 where they show different things.
double correlation(const PointView& view);

/// Returns gain and offset that give the points' intensities the image's mean and spread. Of many
/// points it takes some 600, evenly spread.
Brightness matched_brightness(const PointView& view);

/// Returns the loss scale that the residuals show, intensity; for LossScale::residuals.
double shown_scale(const PointView& view, const Brightness& brightness,
                   const AlignOptions& options);

}  // namespace vo
