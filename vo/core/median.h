#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vo {

/// The middle value; of an even number, the greater of the two in the middle; 0 without values.
template <typename Value>
Value upper_median(std::vector<Value> values) {
  if (values.empty()) {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace vo
