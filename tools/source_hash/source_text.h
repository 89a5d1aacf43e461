#pragma once

#include <string>
#include <string_view>

namespace tools {

/// Returns the code of a C++ source without its comments: each run of white space and comments is
/// one space, or a line's end around a preprocessor directive. Literals are left as they are, raw
/// strings, too.
std::string without_comments(std::string_view source);

}  // namespace tools
