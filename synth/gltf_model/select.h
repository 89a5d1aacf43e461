#pragma once

#include <string>
#include <vector>

namespace synth {

/// Returns the index of the element that `wanted` gives, a name or a number from 0. Throws
/// vo::Error beginning with `place` and listing the names if there is none. `what` is the kind of
/// element.
int select_one(const std::string& wanted, const std::vector<std::string>& names,
               const std::string& what, const std::string& place);

/// Returns the wanted animations' indices: all for "", none for "none", else what select_one does.
std::vector<int> select_animations(const std::string& wanted, const std::vector<std::string>& names,
                                   const std::string& place);

}  // namespace synth
