#include "tools/cluster_simulation/cluster_run.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <nlohmann/json.hpp>

#include "tools/plot/table.h"
#include "vo/core/error.h"

namespace tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kHour = 3600;
constexpr double kPercent = 100;

double share_of(TimeUse use, const ClusterRun& run) {
  return run.all_processor_s() > 0 ? run.time_of(use) / run.all_processor_s() : 0;
}

/// Returns a duration in hours, or below one in seconds.
std::string duration(double seconds) {
  return seconds < kHour ? format_decimals(seconds, 1) + " s"
                         : format_decimals(seconds / kHour, 2) + " h";
}

std::string percent(double share) {
  return format_decimals(kPercent * share, 1) + " %";
}

/// Returns the shares of all processors' time, the greatest first, those below 0.05 % left out.
std::string shares_text(const ClusterRun& run) {
  constexpr double kLeast = 0.0005;
  std::vector<TimeUse> uses;
  for (const auto& [use, name] : enum_names(TimeUse())) {
    if (share_of(use, run) >= kLeast) {
      uses.push_back(use);
    }
  }
  std::stable_sort(uses.begin(), uses.end(),
                   [&](TimeUse a, TimeUse b) { return run.time_of(a) > run.time_of(b); });
  std::string text;
  for (const TimeUse use : uses) {
    text +=
        vo::concat(text.empty() ? "" : ", ", vo::to_string(use), " ", percent(share_of(use, run)));
  }
  return text;
}

/// Returns what limits a run, and what would help.
const char* limit_text(TimeUse use) {
  switch (use) {
    case TimeUse::start:
      return "start of tasks: more parts per task";
    case TimeUse::scenes:
      return "loading of scenes: longer parts, or more per task";
    case TimeUse::lost:
      return "failures of nodes: shorter parts";
    case TimeUse::bandwidth:
      return "the file system's bandwidth: fewer tasks at a time, or smaller frames";
    case TimeUse::metadata:
      return "making of files: fewer tasks at a time, or parts in one file each";
    case TimeUse::scheduler:
      return "the queue's rate of starting tasks: longer parts, or more per task";
    case TimeUse::idle:
      return "too few tasks for so many processors: fewer nodes, or shorter parts";
    case TimeUse::down:
      return "repair of nodes";
    case TimeUse::merge:
      return "merging, which is one process";
    default:
      return "rendering";
  }
}

}  // namespace

double ClusterRun::all_processor_s() const {
  return std::accumulate(processor_s.begin(), processor_s.end(), 0.0);
}

double ClusterRun::allocated_s() const {
  double sum = 0;
  for (const TimeUse use : {TimeUse::rendering, TimeUse::start, TimeUse::scenes, TimeUse::lost,
                            TimeUse::bandwidth, TimeUse::metadata}) {
    sum += time_of(use);
  }
  return sum;
}

double ClusterRun::efficiency() const {
  return allocated_s() > 0 ? time_of(TimeUse::rendering) / allocated_s() : 1;
}

TimeUse ClusterRun::limit() const {
  TimeUse worst = TimeUse::start;
  for (const auto& [use, name] : enum_names(TimeUse())) {
    if (use != TimeUse::rendering && time_of(use) > time_of(worst)) {
      worst = use;
    }
  }
  return worst;
}

std::string format_cluster_run(const ClusterOptions& options, const ClusterRun& run) {
  constexpr double kGigabyte = 1000;
  return vo::concat(
      "cluster     ", options.nodes, " nodes, ", options.nodes * options.tasks_per_node(),
      " tasks at a time; ", run.tasks, " tasks, ", run.parts, " parts, ", run.frames, " frames\n",
      "wall time   ", duration(run.wall_s()), ", of which merging ", duration(run.merge_s), "\n",
      "efficiency  ", percent(run.efficiency()), " of ", duration(run.allocated_s()),
      " of allocated processor time\n",  //
      "failures    ", run.failures, " of nodes, ", run.restarts, " tasks begun again, ",
      duration(run.time_of(TimeUse::lost)), " of processor time lost\n",  //
      "written     ", format_decimals(run.mb / kGigabyte, 1), " GB in ",
      format_decimals(run.files, 0), " files\n",  //
      "processors  ", shares_text(run), "\n",     //
      "limit       ", limit_text(run.limit()), "\n");
}

Json cluster_run_json(const ClusterOptions& options, const ClusterRun& run) {
  ClusterOptions copy = options;
  Json cluster;
  for (const vo::Field& field : vo::fields_of(copy)) {
    cluster[field.key] = field.type == vo::FieldType::real ? Json(vo::parse_real(field.get()))
                                                           : Json(vo::parse_integer(field.get()));
  }
  Json times;
  for (const auto& [use, name] : enum_names(TimeUse())) {
    times[name] = run.time_of(use);
  }
  return {{"cluster", cluster},
          {"frames", run.frames},
          {"parts", run.parts},
          {"tasks", run.tasks},
          {"wall_s", run.wall_s()},
          {"merge_s", run.merge_s},
          {"efficiency", run.efficiency()},
          {"failures", run.failures},
          {"restarts", run.restarts},
          {"bytes", std::round(run.mb * 1e6)},
          {"files", std::round(run.files)},
          {"processor_s", times},
          {"limit", vo::to_string(run.limit())}};
}

}  // namespace tools
