#pragma once

#include <cstddef>
#include <string>

#include "tools/statistics/difference_test.h"

namespace tools {

enum class Sense { less_is_better, more_is_better, neither };

/// Properties of a metric, derived from its name and the number of frames.
struct MetricTraits {
  Sense sense = Sense::less_is_better;
  Resolution resolution;  ///< differences below `negligible` are never large
};

/// Returns the traits of a metric of a sequence of so many frames.
MetricTraits traits_of(const std::string& metric, std::size_t frames);

}  // namespace tools
