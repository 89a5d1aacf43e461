#include "tools/report/svg_axis.h"

#include <algorithm>
#include <cmath>

#include "vo/core/fields.h"

namespace tools {

void Range::include(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

std::vector<double> ticks(const Range& range, int count) {
  const double raw = range.size() / count;
  if (!(raw > 0)) {
    return {range.low};
  }
  const double power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> values;
  for (double i = std::ceil(range.low / step); i * step <= range.high; ++i) {
    values.push_back(i * step);
  }
  return values;
}

std::string tick_label(double value) {
  constexpr double kResolution = 1e9;
  const double rounded = std::round(value * kResolution) / kResolution;
  return vo::format_real(rounded == 0 ? 0 : rounded);
}

double AxisMap::operator()(double value) const {
  const double size = values.size();
  return first_px + (size > 0 ? (value - values.low) / size : 0.5) * (last_px - first_px);
}

}  // namespace tools
