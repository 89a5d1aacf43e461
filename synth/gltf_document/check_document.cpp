#include "synth/gltf_document/check_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synth/gltf_document/check_buffers.h"
#include "synth/gltf_document/check_draco.h"
#include "synth/gltf_document/check_image_based_lights.h"
#include "synth/gltf_document/check_instancing.h"
#include "synth/gltf_document/check_meshes.h"
#include "synth/gltf_document/check_meshopt.h"
#include "synth/gltf_document/check_motion.h"
#include "synth/gltf_document/check_nodes.h"
#include "synth/gltf_document/check_skins.h"
#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/uri.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr std::array kSupportedExtensions = {
    kImageBasedLightExtension, kAnimationPointerExtension,        "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression", "KHR_draco_mesh_compression",      "KHR_lights_punctual",
    "KHR_materials_clearcoat", "KHR_materials_emissive_strength", "KHR_materials_ior",
    "KHR_materials_specular",  "KHR_materials_transmission",      "KHR_materials_unlit",
    "KHR_materials_volume",    "KHR_mesh_quantization",           "KHR_texture_transform"};

/// Unsupported extensions with the glTF Transform command that writes a file without each.
constexpr std::array<std::pair<const char*, const char*>, 5> kConversions = {
    {{"KHR_meshopt_compression", "copy"},
     {"KHR_texture_basisu", "ktxdecompress"},
     {"EXT_texture_webp", "png"},
     {"EXT_texture_avif", "png"},
     {"KHR_materials_pbrSpecularGlossiness", "metalrough"}}};

std::string expected_instead_of(const std::string& extension) {
  for (const auto& [name, command] : kConversions) {
    if (extension == name) {
      return std::string("the output of `npx @gltf-transform/cli ") + command + " in.glb out.glb`";
    }
  }
  return "a file exported without it";
}

void check_asset(const JsonObject& root) {
  const JsonObject asset = root.required_object("asset");
  const std::string version = asset.required_text("version");
  require(version.compare(0, 2, "2.") == 0, asset.place(), ": version is ", version,
          ", expected 2.0");
  const std::string least = asset.text("minVersion").value_or("2.0");
  require(least.compare(0, 2, "2.") == 0, asset.place(), ": minVersion is ", least,
          ", expected 2.0");
}

/// Throws vo::Error if an array of the document has more elements than their readers, which need up
/// to 2 KB for each of a few bytes, shall take memory for.
void check_array_lengths(const nlohmann::json& document, const JsonObject& root) {
  constexpr std::size_t kMost = 500'000;
  for (const auto& [key, array] : document.items()) {
    require(!array.is_array() || array.size() <= kMost, root.place(), ": ", key, " has ",
            array.size(), " elements, expected at most ", kMost);
  }
}

void check_extensions(const JsonObject& root) {
  for (const std::string& name : root.texts("extensionsRequired")) {
    require(is_supported_extension(name), root.place(), ": requires the extension ", name,
            ", which is not supported, expected ", expected_instead_of(name));
  }
  root.texts("extensionsUsed");
}

void check_uris(const JsonObject& root, const std::filesystem::path& folder) {
  for (const char* key : {"buffers", "images"}) {
    for (const JsonObject& object : root.objects(key)) {
      const std::optional<std::string> uri = object.text("uri");
      if (uri && !is_data_uri(*uri)) {
        resolve_uri(folder, *uri, object.place());
      }
    }
  }
}

void check_textures(const JsonObject& root) {
  const std::vector<JsonObject> images = root.objects("images");
  const std::size_t views = root.objects("bufferViews").size();
  const std::size_t samplers = root.objects("samplers").size();
  for (const JsonObject& image : images) {
    require(image.has("uri") != image.has("bufferView"), image.place(),
            ": has both or neither of uri and bufferView, expected one");
    image.index("bufferView", views);
  }
  for (const JsonObject& texture : root.objects("textures")) {
    texture.index("sampler", samplers);
    texture.index("source", images.size());
    const std::optional<JsonObject> extensions = texture.object("extensions");
    for (const std::string& name : extensions ? extensions->keys() : std::vector<std::string>()) {
      extensions->required_object(name).index("source", images.size());
    }
  }
}

void check_texcoord_set(const JsonObject& info) {
  constexpr std::size_t kMost = 1000;  // more than any mesh has
  const std::size_t set = info.whole_number("texCoord").value_or(0);
  require(set <= kMost, info.place(), ": texCoord is ", set, ", expected at most ", kMost);
}

void check_texture_info(const JsonObject& parent, const std::string& key, std::size_t textures) {
  const std::optional<JsonObject> info = parent.object(key);
  if (!info) {
    return;
  }
  info->required_index("index", textures);
  check_texcoord_set(*info);
  if (const auto transform = info->extension("KHR_texture_transform")) {
    transform->numbers("offset", 2);
    transform->numbers("scale", 2);
    transform->number("rotation");
    check_texcoord_set(*transform);
  }
}

void check_alpha(const JsonObject& material) {
  material.text("alphaMode");
  require(material.number("alphaCutoff").value_or(0.5) >= 0, material.place(),
          ": alphaCutoff is negative, expected 0 or more");
  material.flag("doubleSided");
}

/// Checks the texture references of all material extensions, also of unsupported ones.
void check_extended_textures(const JsonObject& material, std::size_t textures) {
  const std::optional<JsonObject> extensions = material.object("extensions");
  for (const std::string& name : extensions ? extensions->keys() : std::vector<std::string>()) {
    if (name.compare(0, 14, "KHR_materials_") != 0) {
      continue;
    }
    const JsonObject extension = extensions->required_object(name);
    for (const std::string& key : extension.keys()) {
      if (key.size() > 7 && key.compare(key.size() - 7, 7, "Texture") == 0) {
        check_texture_info(extension, key, textures);
      }
    }
  }
}

/// The numbers of material extensions that are shares, 0 to 1.
constexpr std::array<std::pair<const char*, const char*>, 4> kShares = {
    {{"KHR_materials_specular", "specularFactor"},
     {"KHR_materials_transmission", "transmissionFactor"},
     {"KHR_materials_clearcoat", "clearcoatFactor"},
     {"KHR_materials_clearcoat", "clearcoatRoughnessFactor"}}};

/// Returns where a member of a material's extension is, with the material's name.
std::string place_in(const JsonObject& material, const JsonObject& extension) {
  const std::string name = material.text("name").value_or("");
  return name.empty() ? extension.place() : vo::concat(extension.place(), " of \"", name, "\"");
}

void check_volume(const JsonObject& material) {
  const auto volume = material.extension("KHR_materials_volume");
  if (!volume) {
    return;
  }
  const std::string place = place_in(material, *volume);
  const double thickness = volume->number("thicknessFactor").value_or(0);
  require(thickness >= 0, place, ": thicknessFactor is ", thickness, ", expected 0 or more");
  const double distance = volume->number("attenuationDistance").value_or(1);
  require(distance > 0, place, ": attenuationDistance is ", distance,
          ", expected a positive number");
  for (const double color : volume->numbers("attenuationColor", 3)) {
    require(color >= 0 && color <= 1, place, ": attenuationColor has ", color, ", expected 0 to 1");
  }
}

/// Checks the factor of a normal map's x and y, beyond which a normal is only a direction.
void check_normal_scale(const JsonObject& map) {
  constexpr double kMost = 1e6;
  const double scale = map.number("scale").value_or(1);
  require(std::abs(scale) <= kMost, map.place(), ": scale is ", scale, ", expected at most ",
          kMost);
}

void check_specular_color(const JsonObject& material) {
  constexpr double kMostSpecularColor = 1e6;
  const auto specular = material.extension("KHR_materials_specular");
  if (!specular) {
    return;
  }
  for (const double color : specular->numbers("specularColorFactor", 3)) {
    require(color >= 0 && color <= kMostSpecularColor, place_in(material, *specular),
            ": specularColorFactor has ", color, ", expected 0 to ", kMostSpecularColor);
  }
}

void check_coat_normal(const JsonObject& material) {
  const auto coat = material.extension("KHR_materials_clearcoat");
  if (const auto normal = coat ? coat->object("clearcoatNormalTexture") : std::nullopt) {
    check_normal_scale(*normal);
  }
}

/// Checks what material extensions say of how a surface reflects and transmits.
void check_reflection(const JsonObject& material) {
  for (const auto& [name, key] : kShares) {
    if (const auto extension = material.extension(name)) {
      const double share = extension->number(key).value_or(0);
      require(share >= 0 && share <= 1, place_in(material, *extension), ": ", key, " is ", share,
              ", expected 0 to 1");
    }
  }
  if (const auto refraction = material.extension("KHR_materials_ior")) {
    const double ior = refraction->number("ior").value_or(1.5);
    require(ior == 0 || ior >= 1, place_in(material, *refraction), ": ior is ", ior,
            ", expected 1 or more, or 0 for a surface that reflects all");
  }
  check_volume(material);
  check_specular_color(material);
  check_coat_normal(material);
}

void check_material(const JsonObject& material, std::size_t textures) {
  material.numbers("emissiveFactor", 3);
  for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
    check_texture_info(material, key, textures);
  }
  if (const auto normal = material.object("normalTexture")) {
    check_normal_scale(*normal);
  }
  if (const auto occlusion = material.object("occlusionTexture")) {
    occlusion->number("strength");
  }
  check_alpha(material);
  check_extended_textures(material, textures);
  if (const auto pbr = material.object("pbrMetallicRoughness")) {
    pbr->numbers("baseColorFactor", 4);
    pbr->number("metallicFactor");
    pbr->number("roughnessFactor");
    check_texture_info(*pbr, "baseColorTexture", textures);
    check_texture_info(*pbr, "metallicRoughnessTexture", textures);
  }
  if (const auto strength = material.extension("KHR_materials_emissive_strength")) {
    require(strength->number("emissiveStrength").value_or(1) >= 0, strength->place(),
            ": emissiveStrength is negative, expected 0 or more");
  }
  check_reflection(material);
}

}  // namespace

bool is_supported_extension(const std::string& name) {
  return std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), name) !=
         kSupportedExtensions.end();
}

void check_document(const GltfFile& file, Notes& notes) {
  const JsonObject root(file.json, file.path.string());
  check_asset(root);
  check_array_lengths(file.json, root);
  check_extensions(root);
  check_uris(root, file.path.parent_path());
  check_buffers(root, notes);
  check_textures(root);
  const std::size_t textures = root.objects("textures").size();
  for (const JsonObject& material : root.objects("materials")) {
    check_material(material, textures);
  }
  check_meshes(root, notes);
  check_node_graph(root);
  check_instancing(root);
  check_skins(root, notes);
  check_motion(root, notes);
  check_image_based_lights(root);
  check_meshopt(root);
  check_draco(root);
}

}  // namespace synth
