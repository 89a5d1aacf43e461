#include "tools/cli/progress_bar.h"

#include <array>
#include <cstdio>
#include <iostream>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

#include "tools/cli/interrupt.h"
#include "tools/colour/colour.h"

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

/// Returns how many characters fit into a line of the terminal.
std::size_t line_width() {
  constexpr std::size_t kUsual = 80;
  winsize size{};
  const bool is_known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return (is_known ? size.ws_col : kUsual) - 1;
}

}  // namespace

ProgressBar::ProgressBar(std::string label, Verbosity verbosity)
    : label_(std::move(label)),
      is_quiet_(verbosity == Verbosity::quiet),
      is_terminal_(kind_of_stream(STDERR_FILENO, colour_environment()) == StreamKind::terminal) {}

void ProgressBar::announce(const std::string& what) {
  if (!is_quiet_ && is_terminal_) {
    const std::string dots = " ...";
    draw(what.substr(0, line_width() - dots.size()) + dots);
  }
}

vo::Progress ProgressBar::callback(const std::string& label) {
  return [this, label](std::size_t done, std::size_t total) {
    throw_if_interrupted();
    show(label, done, total);
  };
}

void ProgressBar::erase() {
  if (has_line_) {
    std::cerr << "\r\033[K" << std::flush;
    has_line_ = false;
  }
}

void ProgressBar::draw(const std::string& line) {
  std::cerr << "\r" << line << "\033[K" << std::flush;
  has_line_ = true;
}

void ProgressBar::show(const std::string& label, std::size_t done, std::size_t total) {
  const auto now = Clock::now();
  const bool is_first = done <= 1;
  if (is_first) {
    start_ = now;
    shown_ = now;
  }
  const bool is_due =
      is_terminal_ ? is_first || now - shown_ >= kTerminalPeriod : now - shown_ >= kPlainPeriod;
  if (is_quiet_ || total == 0 || (!is_due && done < total)) {
    return;
  }
  shown_ = now;
  const Seconds elapsed = now - start_;
  std::array<char, 160> text{};
  if (is_first && done < total) {
    std::snprintf(text.data(), text.size(), "%s %zu of %zu", label.c_str(), done, total);
  } else {
    const double remaining =
        elapsed.count() * static_cast<double>(total - done) / static_cast<double>(done);
    std::snprintf(text.data(), text.size(), "%s %zu of %zu, %.0f s, %.0f s left", label.c_str(),
                  done, total, elapsed.count(), remaining);
  }
  if (!is_terminal_) {
    std::cerr << text.data() << "\n";
    return;
  }
  draw(bar(done, total) + " " + text.data());
  if (done == total) {
    std::cerr << "\n" << std::flush;
    has_line_ = false;
  }
}

}  // namespace tools
