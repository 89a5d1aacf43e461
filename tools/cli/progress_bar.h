#pragma once

#include <chrono>
#include <string>

#include "vo/core/progress.h"

namespace tools {

enum class Verbosity { normal, quiet };

/// Progress on stderr: one line that is redrawn on a terminal, otherwise a plain line every five
/// seconds and one at the end. Every step also throws when a signal was recorded. A line that is
/// not finished is erased by the destructor.
class ProgressBar {
 public:
  ProgressBar(std::string label, Verbosity verbosity);
  ~ProgressBar() { erase(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ProgressBar(ProgressBar&&) = delete;
  ProgressBar& operator=(ProgressBar&&) = delete;

  /// Says on a terminal at once what is being done, until the first step or `erase`: before all
  /// that may take seconds without a step. A text that does not fit into a line is shortened.
  void announce(const std::string& what);
  void announce() { announce(label_); }  ///< announces the steps themselves

  vo::Progress callback() { return callback(label_); }  ///< callback for steps; refers to this bar
  vo::Progress callback(const std::string& label);      ///< callback for steps of another name

  void erase();  ///< erases the line, so that something else can be printed there

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& label, std::size_t done, std::size_t total);
  void draw(const std::string& line);

  std::string label_;
  bool is_quiet_;
  bool is_terminal_;
  bool has_line_ = false;    ///< whether the cursor is in a line that is not finished
  Clock::time_point start_;  ///< end of the first step
  Clock::time_point shown_;
};

}  // namespace tools
