#pragma once

#include <string_view>

namespace synth {

/// Returns whether a pattern is a whole name: `*` is any text, also none and also with `/`, `?` is
/// any one character of UTF-8, and every other character is itself.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace synth
