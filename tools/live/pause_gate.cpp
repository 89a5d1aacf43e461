#include "tools/live/pause_gate.h"

#include <chrono>

namespace tools {

void PauseGate::pause() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  steps_ = 0;
}

void PauseGate::resume() {
  const std::lock_guard lock(mutex_);
  is_paused_ = false;
  steps_ = 0;
  changed_.notify_all();
}

void PauseGate::step() {
  const std::lock_guard lock(mutex_);
  is_paused_ = true;
  ++steps_;
  changed_.notify_all();
}

bool PauseGate::is_paused() const {
  const std::lock_guard lock(mutex_);
  return is_paused_;
}

void PauseGate::pass(const vo::WaitObserver& waiting) {
  constexpr std::chrono::milliseconds kPeriod(50);
  std::unique_lock lock(mutex_);
  while (is_paused_ && steps_ == 0) {
    changed_.wait_for(lock, kPeriod);
    if (waiting) {
      lock.unlock();
      waiting();
      lock.lock();
    }
  }
  if (steps_ > 0) {
    --steps_;
  }
}

}  // namespace tools
