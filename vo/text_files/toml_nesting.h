#pragma once

#include <filesystem>
#include <string_view>

namespace vo {

/// Throws Error naming file and line where a TOML text nests tables deeper than any configuration
/// does: a key of more than 64 parts or more than 16 inline tables within each other. The parser
/// recurses into tables and would run out of stack.
void require_shallow_toml(std::string_view text, const std::filesystem::path& path);

}  // namespace vo
