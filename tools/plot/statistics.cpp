#include "tools/plot/statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace tools {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Spread spread(std::span<const double> values) {
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite),
               [](double value) { return std::isfinite(value); });
  if (finite.empty()) {
    return {kUnknown, kUnknown};
  }
  const double mean = mean_of(finite);
  double squares = 0;
  for (const double value : finite) {
    squares += (value - mean) * (value - mean);
  }
  const double freedom = static_cast<double>(finite.size()) - 1;
  return {mean, freedom > 0 ? std::sqrt(squares / freedom) : 0};
}

double median(std::vector<double> values) {
  if (values.empty()) {
    return kUnknown;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace tools
