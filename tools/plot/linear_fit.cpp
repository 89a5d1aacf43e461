#include "tools/plot/linear_fit.h"

#include <cassert>
#include <cstddef>
#include <numeric>

namespace tools {
namespace {

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

std::optional<LinearFit> fit_line(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  if (x.empty()) {
    return std::nullopt;
  }
  const double mean_x = mean(x);
  const double mean_y = mean(y);
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  if (xx == 0) {
    return std::nullopt;
  }
  const double slope = xy / xx;
  return LinearFit{slope, mean_y - slope * mean_x, yy > 0 ? xy * xy / (xx * yy) : 1};
}

}  // namespace tools
