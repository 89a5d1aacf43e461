#include "tools/cli/progress_bar.h"

#include <cstdio>
#include <iostream>
#include <utility>

#include <unistd.h>

#include "tools/cli/interrupt.h"

namespace tools {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kTerminalPeriod(0.1);
constexpr Seconds kPlainPeriod(5);
constexpr std::size_t kWidth = 30;  // width of the bar, characters

std::string bar(std::size_t done, std::size_t total) {
  const std::size_t filled = kWidth * done / total;
  return "[" + std::string(filled, '#') + std::string(kWidth - filled, ' ') + "]";
}

}  // namespace

ProgressBar::ProgressBar(std::string label, Verbosity verbosity)
    : label_(std::move(label)), verbosity_(verbosity), is_terminal_(isatty(STDERR_FILENO) != 0) {}

vo::Progress ProgressBar::callback() {
  return [this](std::size_t done, std::size_t total) {
    throw_if_interrupted();
    show(done, total);
  };
}

void ProgressBar::show(std::size_t done, std::size_t total) {
  const auto now = Clock::now();
  if (done <= 1) {
    start_ = now;
    shown_ = now;
  }
  const bool due = now - shown_ >= (is_terminal_ ? kTerminalPeriod : kPlainPeriod);
  if (verbosity_ == Verbosity::quiet || total == 0 || (!due && done < total)) {
    return;
  }
  shown_ = now;
  const Seconds elapsed = now - start_;
  const double remaining =
      elapsed.count() * static_cast<double>(total - done) / static_cast<double>(done);
  char text[160];
  std::snprintf(text, sizeof(text), "%s %zu of %zu, %.0f s, %.0f s left", label_.c_str(), done,
                total, elapsed.count(), remaining);
  if (is_terminal_) {
    std::cerr << "\r" << bar(done, total) << " " << text << "\033[K" << (done == total ? "\n" : "")
              << std::flush;
  } else {
    std::cerr << text << "\n";
  }
}

}  // namespace tools
