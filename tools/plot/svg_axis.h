#pragma once

#include <string>
#include <vector>

namespace tools {

/// A closed range of values.
struct Range {
  double low = 0;
  double high = 0;

  double size() const { return high - low; }
  void include(double value);
};

/// Returns round values (1, 2 or 5 times a power of ten apart) within the range, about `count`.
std::vector<double> ticks(const Range& range, int count);

/// Returns the value as a tick label, rounded to 1e-9, without needless digits.
std::string tick_label(double value);

enum class AxisScale { linear, logarithmic };

/// Maps values along one axis to pixels of a drawing.
struct AxisMap {
  Range values;         ///< range of values; above 0 on a logarithmic axis
  double first_px = 0;  ///< position of values.low
  double last_px = 0;   ///< position of values.high
  AxisScale scale = AxisScale::linear;

  double operator()(double value) const;
};

/// Returns round values along an axis: on a linear one about `count` equally spaced ones, on a
/// logarithmic one 1, 2 and 5 times powers of ten, or the powers alone where there are many
/// decades; equally spaced ones, too, where a logarithmic axis has fewer than two of these.
std::vector<double> axis_ticks(const AxisMap& axis, int count);

}  // namespace tools
