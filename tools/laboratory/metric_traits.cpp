#include "tools/laboratory/metric_traits.h"

#include <algorithm>

namespace tools {

MetricTraits traits_of(const std::string& metric, std::size_t frames) {
  if (metric == "keyframes") {
    return {Sense::neither, {.step = 1, .negligible = 1}};
  }
  if (metric.starts_with("nees_") || metric == "depth_nees") {
    return {Sense::neither, {.negligible = 0.2}};
  }
  if (metric == "tracked_fraction") {
    const double frame = 1 / std::max(1.0, static_cast<double>(frames));
    return {Sense::more_is_better, {.step = frame, .negligible = 0.005}};
  }
  if (metric.ends_with("_fraction")) {
    return {Sense::more_is_better, {.negligible = 0.005}};
  }
  if (metric.ends_with("_percent")) {
    return {Sense::less_is_better, {.negligible = 0.02}};
  }
  constexpr double kAngle = 0.005;  // deg
  constexpr double kLength = 5e-5;  // m
  return {Sense::less_is_better, {.negligible = metric.ends_with("_deg") ? kAngle : kLength}};
}

}  // namespace tools
