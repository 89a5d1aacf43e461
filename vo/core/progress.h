#pragma once

#include <cstddef>
#include <functional>

namespace vo {

/// Callback after each step of a long operation, called from any thread but never from two at once.
/// It may throw to stop the operation.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

}  // namespace vo
