#pragma once

#include <string>
#include <string_view>

namespace vo {

/// Returns the name of this machine, "host" where it has none.
std::string host_name();

/// Returns `HOST-PID` of this process. What a process writes without a lock has it in its name, by
/// which others of this machine know what one left that was killed.
std::string process_name();

/// Returns whether a name that begins as `process_name` gives them, and goes on with no digit, is
/// of a process of this machine that has ended.
bool is_of_ended_process(std::string_view name);

}  // namespace vo
