#pragma once

#include <filesystem>
#include <string_view>

#include "vo/core/progress.h"

namespace vo {

/// A device or pipe that is written. While a pipe has no reader yet or is full, `waiting` is called
/// ten times a second, so that one can end the wait by throwing.
class WritableStream {
 public:
  /// Opens a path; stdout is taken as it is, since opening it anew would fail for a socket and cut
  /// a file that it is appended to. Throws Error naming the path.
  WritableStream(std::filesystem::path path, WaitObserver waiting);

  ~WritableStream();
  WritableStream(const WritableStream&) = delete;
  WritableStream& operator=(const WritableStream&) = delete;

  /// Writes bytes behind those before. Throws Error where that fails.
  void append(std::string_view bytes);

  /// Closes the stream. Throws Error where only that tells that something was not written.
  void close();

 private:
  /// Waits until a pipe has room; what cannot be polled, as a file, always has.
  void wait_for_room() const;

  std::filesystem::path path_;
  WaitObserver waiting_;
  int descriptor_;
};

}  // namespace vo
