#include "tools/plot/svg_axis.h"

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
  if (rounded == std::round(rounded) && std::abs(rounded) < kResolution) {
    return std::to_string(std::llround(rounded));
  }
  return vo::format_real(rounded);
}

std::vector<double> axis_ticks(const AxisMap& axis, int count) {
  if (axis.scale == AxisScale::linear) {
    return ticks(axis.values, count);
  }
  std::vector<double> values;
  const int first = static_cast<int>(std::floor(std::log10(axis.values.low)));
  const int last = static_cast<int>(std::floor(std::log10(axis.values.high)));
  const bool has_many = 3 * (last - first) > 2 * count;
  for (int exponent = first; exponent <= last; ++exponent) {
    const double power = std::pow(10, exponent);
    for (const double factor : {1.0, 2.0, 5.0}) {
      if ((factor == 1 || !has_many) && axis.values.low <= factor * power &&
          factor * power <= axis.values.high) {
        values.push_back(factor * power);
      }
    }
  }
  return values.size() < 2 ? ticks(axis.values, count) : values;
}

double AxisMap::operator()(double value) const {
  const double size =
      scale == AxisScale::linear ? values.size() : std::log(values.high / values.low);
  const double along =
      scale == AxisScale::linear ? value - values.low : std::log(value / values.low);
  return first_px + (size > 0 ? along / size : 0.5) * (last_px - first_px);
}

}  // namespace tools
