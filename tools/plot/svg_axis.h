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

/// Round values (1, 2 or 5 times a power of ten apart) within the range, about `count` of them.
std::vector<double> ticks(const Range& range, int count);

/// A value with as few digits as its tick spacing needs.
std::string tick_label(double value);

enum class AxisScale { linear, logarithmic };

/// Maps values to pixels of a drawing.
struct AxisMap {
  Range values;         ///< above 0 on a logarithmic axis
  double first_px = 0;  ///< where values.low is
  double last_px = 0;   ///< where values.high is
  AxisScale scale = AxisScale::linear;

  double operator()(double value) const;
};

/// Round values along an axis: as above, or 1, 2 and 5 times powers of ten on a logarithmic one.
std::vector<double> axis_ticks(const AxisMap& axis, int count);

}  // namespace tools
