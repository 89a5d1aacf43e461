#pragma once

#include <string>
#include <vector>

#include "tools/laboratory/comparison.h"
#include "tools/laboratory/results.h"

namespace tools {

/// Returns JUnit XML as continuous integration reads it (the schema that Jenkins and Maven Surefire
/// share): a test case per scenario with its time, a failure where bounds are violated or alarms
/// raised, an error where nothing could be measured.
std::string format_junit(const TestResults& results, const std::vector<Change>& changes);

}  // namespace tools
