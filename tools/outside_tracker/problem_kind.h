#pragma once

#include <array>
#include <utility>

namespace tools {

/// The reason why a trial has no metrics.
enum class ProblemKind {
  unusable,    ///< the scenario, the scene or the output path is unusable
  temporary,   ///< a retry may succeed, such as after a full disk
  tracker,     ///< the external tracker failed: its exit code, its trajectory, a limit exceeded
  crash,       ///< a signal ended the tracker, external or edvo's own
  timeout,     ///< the external tracker was ended at its time limit
  implausible  ///< the external tracker's trajectory is too good to be true
};

constexpr auto enum_names(ProblemKind) {
  return std::array{std::pair{ProblemKind::unusable, "unusable"},
                    std::pair{ProblemKind::temporary, "temporary"},
                    std::pair{ProblemKind::tracker, "tracker"},
                    std::pair{ProblemKind::crash, "crash"},
                    std::pair{ProblemKind::timeout, "timeout"},
                    std::pair{ProblemKind::implausible, "implausible"}};
}

}  // namespace tools
