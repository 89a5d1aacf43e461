#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/core/error.h"
#include "vo/text_files/toml_file.h"

namespace tools {

/// Returns whether an error's message, `key: ...`, is about the value of a key. A message names the
/// value or a table that it is in, and may leave out what is in front: `move: ...` and
/// `path.move: ...` are about path.move.eye.
bool is_about(const std::string& message, const std::string& value_key);

/// Returns the place of the last value that an error's message is about, or the file where it is
/// about none.
std::string place_of(const std::string& message, const std::vector<vo::TomlValue>& values,
                     const std::filesystem::path& file);

/// The values of a TOML file, which errors are traced back to.
struct ValuesOfFile {
  const std::filesystem::path& file;
  const std::vector<vo::TomlValue>& values;

  /// Runs a check, and throws its vo::Error with the place of the value that it is about in front.
  /// `key`, as `filter: `, is what messages without a key are about.
  template <typename Check>
  void require_valid(const std::string& key, const Check& check) const {
    try {
      check();
    } catch (const vo::Error& error) {
      vo::fail(place_of(key + error.what(), values, file), ": ", error.what());
    }
  }
};

}  // namespace tools
