#pragma once

#include <string>
#include <vector>

namespace synth {

/// The element that `wanted` names: its name, or its number from 0. Throws vo::Error that begins
/// with `place` and lists the names if there is none. `what` says what the elements are.
int select_one(const std::string& wanted, const std::vector<std::string>& names,
               const std::string& what, const std::string& place);

/// All for "", none for "none", one otherwise.
std::vector<int> select_animations(const std::string& wanted, const std::vector<std::string>& names,
                                   const std::string& place);

}  // namespace synth
