#pragma once

#include <string>
#include <vector>

#include "tools/scenario/scenario.h"

namespace tools {

/// What makes a scenario's camera worse than a perfect one: options that are not at their defaults
/// and belong together.
struct Imperfection {
  std::string name;
  Assignments off;  ///< what switches it off
};

/// Those of `sensor.*` and of `camera.distortion`, in the order of the options. Options of one
/// table, such as `sensor.depth`, are one imperfection; a seed is none.
std::vector<Imperfection> find_imperfections(const Scenario& scenario);

Scenario without(const Scenario& scenario, const std::vector<Imperfection>& imperfections);

}  // namespace tools
