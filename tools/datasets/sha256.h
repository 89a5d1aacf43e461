#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tools {

/// Returns the SHA-256 (FIPS 180-4) of bytes as 64 hexadecimal digits, as `sha256sum` prints it.
std::string sha256(std::string_view bytes);

/// Returns the SHA-256 of a file, which is read piece by piece. Throws vo::Error naming the file
/// where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace tools
