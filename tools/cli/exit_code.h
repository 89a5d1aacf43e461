#pragma once

#include "vo/core/error.h"

/// Exit codes of the program. They are documented in README.md and stable.
namespace tools::exit_code {

inline constexpr int kOk = 0;
inline constexpr int kInternalError = 1;
inline constexpr int kUsage = 2;          ///< the command line is wrong
inline constexpr int kUnusableInput = 3;  ///< unusable input, configuration, scene or output path
inline constexpr int kBoundViolated = 4;  ///< a bound or a baseline comparison failed
inline constexpr int kTrackingLost = 5;   ///< frames are lost or uncertain
inline constexpr int kMissing = 5;        ///< parts of what is put together are missing
inline constexpr int kOutputExists = 6;   ///< an output exists and differs; --force replaces it
inline constexpr int kTemporary = 75;     ///< a retry may succeed: disk full, terminated
inline constexpr int kInterrupted = 130;

inline int of(vo::ErrorKind kind) {
  switch (kind) {
    case vo::ErrorKind::usage:
      return kUsage;
    case vo::ErrorKind::input:
      return kUnusableInput;
    case vo::ErrorKind::output_exists:
      return kOutputExists;
    case vo::ErrorKind::temporary:
      return kTemporary;
    case vo::ErrorKind::interrupted:
      return kInterrupted;
  }
  return kInternalError;
}

}  // namespace tools::exit_code
