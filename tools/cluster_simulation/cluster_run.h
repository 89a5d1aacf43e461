#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/cluster_simulation/cluster_options.h"
#include "vo/core/fields.h"

namespace tools {

/// What a processor's time went to, from the submission until the data set is merged.
enum class TimeUse {
  rendering,  ///< of frames that are kept, their writing included
  start,      ///< of tasks
  scenes,     ///< loading them
  lost,       ///< parts that a failure broke off
  bandwidth,  ///< waiting for the file system's bandwidth
  metadata,   ///< waiting for the file system to make files
  scheduler,  ///< idle while tasks wait to be started
  idle,       ///< no task is left that could be started
  down,       ///< its node is being repaired
  merge       ///< while one process merges
};

constexpr auto enum_names(TimeUse) {
  return std::array{
      std::pair{TimeUse::rendering, "rendering"}, std::pair{TimeUse::start, "start"},
      std::pair{TimeUse::scenes, "scenes"},       std::pair{TimeUse::lost, "lost"},
      std::pair{TimeUse::bandwidth, "bandwidth"}, std::pair{TimeUse::metadata, "metadata"},
      std::pair{TimeUse::scheduler, "scheduler"}, std::pair{TimeUse::idle, "idle"},
      std::pair{TimeUse::down, "down"},           std::pair{TimeUse::merge, "merge"}};
}

/// What an array job comes to.
struct ClusterRun {
  std::size_t frames = 0;
  std::size_t parts = 0;  ///< each is done once
  std::size_t tasks = 0;
  double render_s = 0;         ///< from the submission until the last part is done, s
  double merge_s = 0;          ///< after it, s
  std::size_t failures = 0;    ///< of nodes, until the last part is done
  std::size_t restarts = 0;    ///< tasks that a failure ended
  std::size_t broken_off = 0;  ///< parts that a failure ended
  double mb = 0;               ///< written and kept, MB
  double files = 0;            ///< written and kept
  std::array<double, enum_names(TimeUse()).size()> processor_s{};  ///< by TimeUse, s

  double wall_s() const { return render_s + merge_s; }
  double time_of(TimeUse use) const { return processor_s[static_cast<std::size_t>(use)]; }
  double all_processor_s() const;  ///< all processors' time from submission to merge, s
  double allocated_s() const;      ///< time of processors that tasks had, s
  double efficiency() const;       ///< share of the allocated time that is rendering

  /// Returns what takes the most of all processors' time beside rendering.
  TimeUse limit() const;
};

/// Returns the run as text for people, several lines.
std::string format_cluster_run(const ClusterOptions& options, const ClusterRun& run);

/// Returns options and run as a member of a JSON document.
nlohmann::ordered_json cluster_run_json(const ClusterOptions& options, const ClusterRun& run);

}  // namespace tools
