#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>

#include "vo/core/progress.h"

namespace tools {

/// Lets a viewer hold a run up between two frames.
class PauseGate {
 public:
  void pause();
  void resume();
  void step();  ///< pauses, and lets one more frame pass

  bool is_paused() const;

  /// Lets a frame pass: returns at once unless the run is paused, else when it may go on. `waiting`
  /// is called repeatedly until then, and may throw.
  void pass(const vo::WaitObserver& waiting);

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool is_paused_ = false;
  std::size_t steps_ = 0;  ///< number of frames that may pass although the run is paused
};

}  // namespace tools
