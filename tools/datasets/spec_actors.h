#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/text_files/toml_file.h"

namespace tools {

/// A table `[[actor]]` of a data set's spec.
struct SpecActor {
  std::vector<vo::TomlValue> values;  ///< as in a scenario, its file's path absolute
  std::vector<std::string> scenes;    ///< names of the scenes that it goes through; none: all
  std::string place;                  ///< of the table's first value, for messages

  bool goes_through(const std::string& scene) const;
};

/// Removes the tables `[[actor]]` from the values of a spec and returns them. Their files are in
/// the spec's folder unless their paths are absolute. Throws vo::Error with file:line.
std::vector<SpecActor> take_spec_actors(std::vector<vo::TomlValue>& values,
                                        const std::filesystem::path& spec);

}  // namespace tools
