#pragma once

#include <cstddef>
#include <functional>

namespace vo {

/// Callback after each step of a long operation, called from any thread but never from two at once.
/// It may throw to stop the operation.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// Callback that is called repeatedly while an operation waits for another process, or goes on
/// without steps that could be counted; it may throw to stop the operation. An empty one is not
/// called.
using WaitObserver = std::function<void()>;

}  // namespace vo
