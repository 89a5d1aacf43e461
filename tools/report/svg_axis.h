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

/// Maps values linearly to pixels of a drawing.
struct AxisMap {
  Range values;
  double first_px = 0;  ///< where values.low is
  double last_px = 0;   ///< where values.high is

  double operator()(double value) const;
};

}  // namespace tools
