#pragma once

#include <filesystem>
#include <vector>

#include "synth/gltf/actor.h"
#include "vo/text_files/toml_file.h"

namespace tools {

/// Removes the tables `[[actor]]` from the values of a TOML file and returns the actors that they
/// are, whose files that are no absolute paths are in `folder`. Throws vo::Error with file:line.
std::vector<synth::ActorOptions> take_actors(std::vector<vo::TomlValue>& values,
                                             const std::filesystem::path& folder);

/// Reads a TOML file of tables `[[actor]]`, at least one, and nothing else, whose files are in its
/// folder; no actors where no file is given. Throws as take_actors does.
std::vector<synth::ActorOptions> load_actors(const std::filesystem::path& file);

}  // namespace tools
