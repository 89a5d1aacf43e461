#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "synth/gltf_document/notes.h"
#include "synth/gltf_materials/needed_textures.h"
#include "synth/scene/scene.h"

namespace synth {

/// Options that select the parts of a glTF file to read. Its elements are known by their names or
/// by their numbers from 0.
struct GltfOptions {
  std::string scene;      ///< "" = the default scene, else the first; all nodes if there is none
  std::string animation;  ///< "" = all but those that move what an earlier one does; "none"; or one
  bool loop = false;      ///< animations restart at their end instead of holding their last pose
  double scale = 1;       ///< factor of all lengths, for a file whose unit is not the metre
  std::string environment;          ///< Scene::environment instead of the file's, by SceneFile
  double environment_turn = 0;      ///< deg about +y, of that image or the file's, by SceneFile
  double environment_strength = 1;  ///< factor of its light, by SceneFile
  NeededTextures needed = NeededTextures::all;

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, GltfOptions& options) {
  visit("scene", options.scene, "scene of the file, name or number [the default one]");
  visit("animation", options.animation, "animation that plays, name or number, or none [all]");
  visit("loop", options.loop, "animations start again at their end instead of holding still");
  visit("scale", options.scale, "factor of the whole scene, 0.001 for a file in millimetres");
  visit("environment", options.environment,
        "light from all sides: FILE.hdr or .exr, or sky:ELEVATION[,TURBIDITY], deg");
  visit("environment_turn", options.environment_turn, "of the environment about the vertical, deg");
  visit("environment_strength", options.environment_strength, "factor of the environment's light");
}

/// Reads a .gltf or .glb file. Throws vo::Error naming the file, the element and what was expected.
/// Opens nothing outside the file's own folder. `notes`, if given, receives what was left out.
Scene load_gltf(const std::filesystem::path& path, const GltfOptions& options,
                Notes* notes = nullptr);
Scene load_gltf(const std::filesystem::path& path, Notes* notes = nullptr);

/// Reads the content of a .gltf or .glb file as load_gltf does. `path` names it in messages, and
/// its folder is where the content's references lead.
Scene parse_gltf(std::span<const std::uint8_t> content, const std::filesystem::path& path,
                 const GltfOptions& options = {}, Notes* notes = nullptr);

}  // namespace synth
