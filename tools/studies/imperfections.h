#pragma once

#include <string>
#include <vector>

#include "tools/scenario/scenario.h"

namespace tools {

/// An imperfection of a scenario's camera: options that belong together and are not at their
/// default.
struct Imperfection {
  std::string name;
  Assignments off;  ///< assignments that restore the defaults
};

/// Returns the imperfections among `sensor.*` and `camera.distortion`, in option order. Options of
/// one table, such as `sensor.depth`, form one imperfection; seeds and presets do not count.
std::vector<Imperfection> find_imperfections(const Scenario& scenario);

Scenario without(const Scenario& scenario, const std::vector<Imperfection>& imperfections);

}  // namespace tools
