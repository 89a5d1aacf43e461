#include "vo/residuals/view_agreement.h"

#include <array>

#include "vo/residuals/intensity_moments.h"

namespace vo {

ViewAgreement view_agreement(const PointView& view, const PointTerms& terms,
                             const ResidualModel& model) {
  constexpr double kEnoughInCell = 12;
  constexpr double kAgreeing = 0.3;
  const ViewCells cells(view.image.camera);
  std::array<IntensityMoments, ViewCells::kCount> moments;
  for (std::size_t i = 0; i < terms.weight.size(); ++i) {
    if (terms.weight[i] > 0) {
      const double ref = view.points.intensity[i];
      const double cur = terms.residual[i] + model.brightness.gain * ref + model.brightness.offset;
      moments.at(cells.of(terms.u[i], terms.v[i])).add(ref, cur);
    }
  }
  ViewAgreement result;
  IntensityMoments agreeing;
  double disagreeing = 0;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const IntensityMoments& cell = moments.at(k);
    result.disagreeing[k] = cell.n >= kEnoughInCell && cell.correlation() < kAgreeing;
    if (result.disagreeing[k]) {
      disagreeing += cell.n;
    } else {
      agreeing.add(cell);
    }
  }
  const double seen = disagreeing + agreeing.n;
  result.disagreeing_fraction = seen > 0 ? disagreeing / seen : 0;
  result.agreeing_correlation = agreeing.correlation();
  return result;
}

}  // namespace vo
