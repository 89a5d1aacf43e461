#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace tools {

/// What each of some players adds to a value that any set of them has (Shapley 1953): the mean,
/// over all orders in which they may join, of what the value rises by when it joins. The shares sum
/// to the value of all less that of none. Bit i of a set is player i; each set is asked for once.
std::vector<double> shapley_values(int players, const std::function<double(std::uint32_t)>& value);

}  // namespace tools
