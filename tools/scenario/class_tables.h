#pragma once

#include <filesystem>
#include <vector>

#include "synth/truth/surface_classes.h"
#include "vo/text_files/toml_file.h"

namespace tools {

/// Removes the tables `[[class]]` from the values of a TOML file and returns the classes that they
/// are: `name`, and `nodes` and `materials`, arrays of patterns. Throws vo::Error with file:line.
std::vector<synth::SurfaceClass> take_classes(std::vector<vo::TomlValue>& values);

/// Reads a TOML file of tables `[[class]]`, at least one, and nothing else. Throws as take_classes
/// does.
std::vector<synth::SurfaceClass> load_classes(const std::filesystem::path& file);

}  // namespace tools
