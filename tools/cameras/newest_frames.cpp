#include "tools/cameras/newest_frames.h"

#include <utility>

#include "vo/core/error.h"

namespace tools {

NewestFrames::NewestFrames(LiveCamera camera, std::size_t most, std::function<bool()> is_stopped)
    : camera_(std::move(camera)),
      most_(most),
      is_stopped_(std::move(is_stopped)),
      thread_([this] { read(); }) {}

std::optional<vo::RgbdFrame> NewestFrames::next() {
  if (most_ > 0 && returned_ == most_) {
    return std::nullopt;
  }
  std::unique_lock lock(mutex_);
  has_news_.wait(lock, [&] { return newest_ || has_ended_; });
  returned_ += newest_ ? 1 : 0;
  return std::exchange(newest_, std::nullopt);
}

NewestFrames::End NewestFrames::finish() {
  end_reading();
  End end{replaced_ + (newest_ ? 1 : 0) + camera_.missed(), ""};
  if (failure_) {
    try {
      std::rethrow_exception(failure_);
    } catch (const vo::Error& error) {
      if (returned_ == 0) {
        throw;
      }
      end.failure = error.what();
    }
  }
  vo::require(returned_ > 0, camera_.device, ": has given no frame before it was stopped");
  return end;
}

void NewestFrames::read() {
  const auto is_over = [this] {
    const std::scoped_lock lock(mutex_);
    return is_told_to_end_ || is_stopped_();
  };
  std::exception_ptr failure;
  try {
    while (std::optional<vo::RgbdFrame> frame = camera_.next(is_over)) {
      const std::scoped_lock lock(mutex_);
      replaced_ += newest_ ? 1 : 0;
      newest_ = std::move(frame);
      has_news_.notify_one();
    }
  } catch (...) {
    failure = std::current_exception();
  }
  const std::scoped_lock lock(mutex_);
  failure_ = failure;
  has_ended_ = true;
  has_news_.notify_one();
}

void NewestFrames::end_reading() {
  {
    const std::scoped_lock lock(mutex_);
    is_told_to_end_ = true;
  }
  if (thread_.joinable()) {
    thread_.join();
  }
}

}  // namespace tools
