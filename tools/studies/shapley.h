#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace tools {

/// Returns the Shapley value of each player (Shapley 1953): the mean, over all orders in which the
/// players may join, of the rise of `value` when this player joins. They sum to the value of all
/// players less that of none. Bit i of a set is player i; `value` is called once for each set.
std::vector<double> shapley_values(int players, const std::function<double(std::uint32_t)>& value);

}  // namespace tools
