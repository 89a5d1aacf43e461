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
  std::size_t frames = 0;  ///< with those of the warm-up
  RaceOptions options;
  std::vector<Summary> peers;
  std::vector<Absence> absent;
  std::vector<GrowthTable> growth;  ///< empty unless asked for
};

/// The machine's name for its processor, "unknown" where it does not say.
std::string cpu_model();

/// Whose time the others' is divided into: OpenCV's dense odometry where it ran, else the slowest.
/// Nothing of fewer than two.
const Summary* yardstick(const std::vector<Summary>& peers);

std::string bench_table(const BenchReport& report);
nlohmann::ordered_json bench_json(const BenchReport& report);

}  // namespace tools
