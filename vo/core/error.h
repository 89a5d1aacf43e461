#pragma once

#include <array>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace vo {

/// The reason why an operation failed, from which the program's exit code follows.
enum class ErrorKind {
  usage,          ///< the caller asked for something that does not exist
  input,          ///< a file, folder, scene or option value that cannot be used
  output_exists,  ///< the result would replace something else
  temporary,      ///< the same call may succeed later (disk full, terminated)
  interrupted,    ///< the user stopped the operation
};

constexpr auto enum_names(ErrorKind) {
  return std::array{std::pair{ErrorKind::usage, "usage"}, std::pair{ErrorKind::input, "input"},
                    std::pair{ErrorKind::output_exists, "output_exists"},
                    std::pair{ErrorKind::temporary, "temporary"},
                    std::pair{ErrorKind::interrupted, "interrupted"}};
}

/// The only exception this project throws. Losing track is a value (`TrackingStatus`), a broken
/// invariant is an `assert`. The message is one sentence: where, what is wrong, what was expected.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, ErrorKind kind = ErrorKind::input)
      : std::runtime_error(message), kind_(kind) {}

  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

/// Returns the parts, streamed into one string. Throws std::bad_alloc where memory ends; a stream
/// of the standard library would leave out a part and say nothing.
template <typename... Parts>
std::string concat(const Parts&... parts) {
  std::ostringstream text;
  text.exceptions(std::ios_base::badbit);
  (text << ... << parts);
  return text.str();
}

/// Throws an Error of kind `input` whose message is the parts, streamed:
/// `fail(path, ": no depth folder")`.
template <typename... Parts>
[[noreturn]] void fail(const Parts&... parts) {
  throw Error(concat(parts...));
}

/// Throws an Error of the given kind whose message is the parts, streamed.
template <typename... Parts>
[[noreturn]] void fail_as(ErrorKind kind, const Parts&... parts) {
  throw Error(concat(parts...), kind);
}

/// Throws an Error of kind `input` whose message is the parts, streamed, unless the condition
/// holds.
template <typename... Parts>
void require(bool condition, const Parts&... parts) {
  if (!condition) {
    fail(parts...);
  }
}

}  // namespace vo
