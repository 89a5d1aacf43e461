#pragma once

#include <string>

namespace tools {

/// Returns the name of this machine, "host" where it has none.
std::string host_name();

}  // namespace tools
