#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/processes/printed.h"
#include "vo/core/progress.h"

namespace tools {

/// Returns the path of the program that this process runs.
std::filesystem::path own_program();

/// Runs a command of edvo and returns what it printed. Throws vo::Error with its message, of the
/// kind of its exit code, where this is not among `answers`.
Printed ask_program(const ChildCommand& command, std::initializer_list<int> answers,
                    const vo::WaitObserver& waiting);

/// Returns a member of the document that a command printed. Throws vo::Error where it is none, or
/// has no such member.
nlohmann::json printed_member(const Printed& printed, const std::string& name);

}  // namespace tools
