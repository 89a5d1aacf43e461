#pragma once

#include <string>
#include <string_view>

namespace vo {

/// Throws Error beginning with `place`, the document's file, where a JSON text nests arrays and
/// objects more than 100 levels deep, or holds more than 20 million values: what walks through a
/// parsed document recurses and would run out of stack, and a value takes more memory than its
/// text.
void require_json_within_limits(std::string_view text, const std::string& place);

}  // namespace vo
