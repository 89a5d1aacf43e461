#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "synth/gltf_model/notes.h"
#include "synth/scene/scene.h"

namespace synth {

/// Which part of a file to read. Names are the file's; its elements are also known by their
/// numbers, from 0.
struct GltfOptions {
  std::string scene;      ///< "" = the file's default, else its first; all nodes if it has none
  std::string animation;  ///< "" = in the file's order all that move nothing twice, "none", or one
  bool loop = false;      ///< animations start again at their end instead of holding still
};

template <typename Visitor>
void visit_fields(Visitor& visit, GltfOptions& options) {
  visit("scene", options.scene, "scene of the file, name or number [the default one]");
  visit("animation", options.animation, "animation that plays, name or number, or none [all]");
  visit("loop", options.loop, "animations start again at their end instead of holding still");
}

/// Reads .gltf or .glb. Throws vo::Error naming the file, the element and what was expected;
/// nothing outside the file's own folder is opened. `notes`, if given, receives what was skipped.
Scene load_gltf(const std::filesystem::path& path, const GltfOptions& options,
                Notes* notes = nullptr);
Scene load_gltf(const std::filesystem::path& path, Notes* notes = nullptr);

/// The same of a file's content. `path` names it in messages; its folder is where the file's own
/// references lead.
Scene parse_gltf(std::span<const std::uint8_t> content, const std::filesystem::path& path,
                 const GltfOptions& options = {}, Notes* notes = nullptr);

}  // namespace synth
