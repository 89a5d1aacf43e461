#pragma once

#include <string>
#include <string_view>

namespace tools {

/// Returns the text in a form fit for JSON, XML and a terminal: control characters and bytes that
/// are not UTF-8 (RFC 3629) become '?'.
std::string readable_text(std::string_view bytes);

}  // namespace tools
