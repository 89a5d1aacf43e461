#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>

#include "vo/core/progress.h"

namespace tools {

/// A place for one value between a thread that makes values and one that takes them. Who makes them
/// never waits unless it asks to: it asks whether a value would be taken, and drops it where not.
template <typename Value>
class LatestSlot {
 public:
  /// Returns whether a value would be taken at once: somebody waits for one, and none lies there.
  bool is_wanted() const {
    const std::lock_guard lock(mutex_);
    return is_taker_waiting_ && !value_;
  }

  /// Puts a value in place of one that nobody has taken.
  void put(Value value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
    changed_.notify_all();
  }

  /// Returns once a value would be taken or the slot is closed. `waiting` is called repeatedly
  /// until then, and may throw.
  void wait_until_wanted(const vo::WaitObserver& waiting) {
    constexpr std::chrono::milliseconds kPeriod(20);
    std::unique_lock lock(mutex_);
    while (!is_closed_ && (!is_taker_waiting_ || value_)) {
      changed_.wait_for(lock, kPeriod);
      if (waiting) {
        lock.unlock();
        waiting();
        lock.lock();
      }
    }
  }

  /// Takes the value, waiting for one. Empty when the slot is closed.
  std::optional<Value> take() {
    std::unique_lock lock(mutex_);
    is_taker_waiting_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return is_closed_ || value_; });
    is_taker_waiting_ = false;
    return std::exchange(value_, std::nullopt);
  }

  /// Waits for a while, or until the slot is closed.
  void rest(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, time, [this] { return is_closed_; });
  }

  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Value> value_;
  bool is_taker_waiting_ = false;
  bool is_closed_ = false;
};

}  // namespace tools
