#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/bench/growth.h"
#include "tools/bench/peer.h"
#include "tools/bench/race.h"
#include "tools/bench/summary.h"

namespace tools {

/// All that `edvo bench` prints.
struct BenchReport {
  std::string input;
  std::string cpu;
  int width = 0;           ///< px
  int height = 0;          ///< px
  std::size_t frames = 0;  ///< number of frames, including the warm-up
  RaceOptions options;
  std::vector<Summary> peers;
  std::vector<Absence> absent;
  std::vector<GrowthTable> growth;  ///< empty unless growth was measured
};

/// Races those who line up. `input` names the frames.
BenchReport race_peers(const std::string& input, const Frames& frames, LineUp line,
                       const RaceOptions& options, const vo::Progress& progress);

/// Returns the processor's name from /proc/cpuinfo, or "unknown".
std::string cpu_model();

/// Returns the peer to which speed-ups refer: OpenCV's dense odometry where it ran, else the
/// slowest one. It is null with fewer than two peers.
const Summary* yardstick(const std::vector<Summary>& peers);

std::string bench_table(const BenchReport& report);
nlohmann::ordered_json bench_json(const BenchReport& report);

}  // namespace tools
