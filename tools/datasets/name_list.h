#pragma once

#include <string>
#include <vector>

namespace tools {

/// Returns the names of a list such as `room, desk`.
std::vector<std::string> names_in(const std::string& list);

}  // namespace tools
