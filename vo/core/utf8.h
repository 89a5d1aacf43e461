#pragma once

#include <cstddef>
#include <string_view>

namespace vo {

/// Returns the number of bytes of the UTF-8 character (RFC 3629) at the start of a text that is not
/// empty; 0 where its bytes are none.
std::size_t utf8_length(std::string_view text);

}  // namespace vo
