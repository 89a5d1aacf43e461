#pragma once

#include <string>
#include <string_view>

namespace tools {

/// As text or as the value of an attribute of HTML or XML.
std::string escaped_markup(std::string_view text);

}  // namespace tools
