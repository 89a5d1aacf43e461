#pragma once

#include <string>
#include <string_view>

namespace tools {

/// Returns the text escaped for use as text or attribute value in HTML or XML.
std::string escaped_markup(std::string_view text);

}  // namespace tools
