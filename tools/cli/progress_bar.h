#pragma once

#include <chrono>
#include <string>

#include "vo/core/progress.h"

namespace tools {

enum class Verbosity { normal, quiet };

/// Progress on stderr: one line that is redrawn on a terminal, otherwise a plain line every five
/// seconds and one at the end. Every step also throws when a signal was recorded.
class ProgressBar {
 public:
  ProgressBar(std::string label, Verbosity verbosity);

  vo::Progress callback();  ///< callback for the steps; refers to this bar

 private:
  using Clock = std::chrono::steady_clock;

  void show(std::size_t done, std::size_t total);

  std::string label_;
  Verbosity verbosity_;
  bool is_terminal_;
  Clock::time_point start_;  ///< end of the first step
  Clock::time_point shown_;
};

}  // namespace tools
