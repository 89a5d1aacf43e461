#pragma once

#include "vo/image/view_grid.h"
#include "vo/residuals/linearize.h"
#include "vo/residuals/point_pass.h"

namespace vo {

/// Where in the view two aligned images show the same thing. What moves by itself, is stuck or
/// covers the view disagrees cell by cell, however well the rest agrees.
struct ViewAgreement {
  ViewCells::Set disagreeing;       ///< cells of the current image
  double disagreeing_fraction = 0;  ///< share of the points that lie in such cells
  double agreeing_correlation = 0;  ///< Pearson's correlation over all other points
};

/// Judges each cell in which enough points are seen by the correlation of their intensities.
/// `terms` must have been computed from the view with this model.
ViewAgreement view_agreement(const PointView& view, const PointTerms& terms,
                             const ResidualModel& model);

}  // namespace vo
