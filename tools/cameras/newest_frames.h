#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "tools/cameras/live_camera.h"

namespace tools {

/// Frames of a running camera for somebody who may need longer for one than the camera: they are
/// read in a thread of its own, the newest is kept, and those that a newer one replaced are
/// dropped.
class NewestFrames {
 public:
  /// `most` frames are returned at most, 0 = any number. `is_stopped` is asked in the thread and
  /// says when to end.
  NewestFrames(LiveCamera camera, std::size_t most, std::function<bool()> is_stopped);
  ~NewestFrames() { end_reading(); }
  NewestFrames(const NewestFrames&) = delete;
  NewestFrames& operator=(const NewestFrames&) = delete;
  NewestFrames(NewestFrames&&) = delete;
  NewestFrames& operator=(NewestFrames&&) = delete;

  /// Waits for a frame that was not returned yet; nothing when the camera was stopped, has ended or
  /// has failed, or when there were as many as wanted.
  std::optional<vo::RgbdFrame> next();

  /// How the reading ended.
  struct End {
    std::size_t dropped = 0;  ///< frames of the device that `next` did not return
    std::string failure;      ///< sentence of the camera's error; empty without one
  };

  /// Ends the reading. Throws what the camera has thrown, or vo::Error, where it has given no
  /// frame.
  End finish();

 private:
  void read();
  void end_reading();

  LiveCamera camera_;
  std::size_t most_;
  std::function<bool()> is_stopped_;
  std::size_t returned_ = 0;
  std::mutex mutex_;  ///< of all below but the thread itself
  std::condition_variable has_news_;
  std::optional<vo::RgbdFrame> newest_;
  std::size_t replaced_ = 0;
  std::exception_ptr failure_;
  bool is_told_to_end_ = false;
  bool has_ended_ = false;
  std::thread thread_;
};

}  // namespace tools
