#include "synth/gltf_check.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synth/gltf_check_buffers.h"
#include "synth/gltf_check_motion.h"
#include "synth/gltf_check_nodes.h"
#include "synth/gltf_json.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr std::array kSupportedExtensions = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform"};

/// The glTF Transform commands that write a file without the extension.
constexpr std::array<std::pair<const char*, const char*>, 5> kConversions = {
    {{"KHR_draco_mesh_compression", "copy"},
     {"EXT_meshopt_compression", "copy"},
     {"KHR_texture_basisu", "ktxdecompress"},
     {"EXT_texture_webp", "png"},
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
  require(least == "2.0", asset.place(), ": minVersion is ", least, ", expected 2.0");
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
  }
}

void check_texture_info(const JsonObject& parent, const std::string& key, std::size_t textures) {
  const std::optional<JsonObject> info = parent.object(key);
  if (!info) {
    return;
  }
  info->required_index("index", textures);
  info->whole_number("texCoord");
  if (const auto transform = info->extension("KHR_texture_transform")) {
    transform->numbers("offset", 2);
    transform->numbers("scale", 2);
    transform->number("rotation");
    transform->whole_number("texCoord");
  }
}

void check_alpha(const JsonObject& material) {
  const std::string mode = material.text("alphaMode").value_or("OPAQUE");
  require(mode == "OPAQUE" || mode == "MASK" || mode == "BLEND", material.place(),
          ": alphaMode is ", mode, ", expected OPAQUE, MASK or BLEND");
  require(material.number("alphaCutoff").value_or(0.5) >= 0, material.place(),
          ": alphaCutoff is negative, expected 0 or more");
  material.flag("doubleSided");
}

void check_material(const JsonObject& material, std::size_t textures) {
  material.numbers("emissiveFactor", 3);
  for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
    check_texture_info(material, key, textures);
  }
  if (const auto normal = material.object("normalTexture")) {
    normal->number("scale");
  }
  if (const auto occlusion = material.object("occlusionTexture")) {
    occlusion->number("strength");
  }
  check_alpha(material);
  if (const auto pbr = material.object("pbrMetallicRoughness")) {
    pbr->numbers("baseColorFactor", 4);
    pbr->number("metallicFactor");
    pbr->number("roughnessFactor");
    check_texture_info(*pbr, "baseColorTexture", textures);
    check_texture_info(*pbr, "metallicRoughnessTexture", textures);
  }
  if (const auto strength = material.extension("KHR_materials_emissive_strength")) {
    strength->number("emissiveStrength");
  }
}

/// Nothing for attributes that the loader does not read.
std::vector<std::string> attribute_types(const std::string& name) {
  if (name == "POSITION" || name == "NORMAL") {
    return {"VEC3"};
  }
  if (name.compare(0, 9, "TEXCOORD_") == 0) {
    return {"VEC2"};
  }
  if (name == "TANGENT") {
    return {"VEC4"};
  }
  if (name == "COLOR_0") {
    return {"VEC3", "VEC4"};
  }
  return {};
}

void check_attributes(const JsonObject& attributes, const std::vector<JsonObject>& accessors) {
  std::optional<std::size_t> vertices;
  if (const auto position = attributes.index("POSITION", accessors.size())) {
    vertices = accessors[*position].required_whole_number("count");
  }
  for (const std::string& name : attributes.keys()) {
    const JsonObject& accessor = accessors[attributes.required_index(name, accessors.size())];
    const std::size_t count = accessor.required_whole_number("count");
    require(!vertices || count == *vertices, attributes.place(), ": ", name, " has ", count,
            " elements, expected ", vertices.value_or(0), " as POSITION has");
    const std::vector<std::string> types = attribute_types(name);
    const std::string type = accessor.required_text("type");
    require(types.empty() || std::find(types.begin(), types.end(), type) != types.end(),
            attributes.place(), ": ", name, " is of type ", type, ", expected ",
            types.empty() ? "" : types.front());
  }
}

void check_primitive(const JsonObject& primitive, const std::vector<JsonObject>& accessors,
                     std::size_t materials) {
  primitive.index("material", materials);
  const std::size_t mode = primitive.whole_number("mode").value_or(4);
  require(mode <= 6, primitive.place(), ": mode is ", mode, ", expected 0 to 6");
  if (const auto indices = primitive.index("indices", accessors.size())) {
    const JsonObject& accessor = accessors[*indices];
    require(accessor.required_text("type") == "SCALAR" &&
                is_unsigned_component(accessor.required_whole_number("componentType")),
            primitive.place(), ": indices is accessors[", *indices,
            "] of another type, expected unsigned SCALAR");
  }
  check_attributes(primitive.required_object("attributes"), accessors);
  for (const JsonObject& target : primitive.objects("targets")) {
    for (const std::string& name : target.keys()) {
      target.index(name, accessors.size());
    }
  }
}

void check_meshes(const JsonObject& root) {
  const std::vector<JsonObject> accessors = root.objects("accessors");
  const std::size_t materials = root.objects("materials").size();
  for (const JsonObject& mesh : root.objects("meshes")) {
    for (const JsonObject& primitive : mesh.objects("primitives")) {
      check_primitive(primitive, accessors, materials);
    }
  }
}

}  // namespace

bool is_supported_extension(const std::string& name) {
  return std::find(kSupportedExtensions.begin(), kSupportedExtensions.end(), name) !=
         kSupportedExtensions.end();
}

void check_document(const GltfFile& file) {
  const JsonObject root(file.json, file.path.string());
  check_asset(root);
  check_extensions(root);
  check_uris(root, file.path.parent_path());
  check_buffers(root);
  check_textures(root);
  const std::size_t textures = root.objects("textures").size();
  for (const JsonObject& material : root.objects("materials")) {
    check_material(material, textures);
  }
  check_meshes(root);
  check_node_graph(root);
  check_motion(root);
}

}  // namespace synth
