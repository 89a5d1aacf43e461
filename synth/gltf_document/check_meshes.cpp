#include "synth/gltf_document/check_meshes.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "synth/gltf_document/check_buffers.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr std::size_t kByte = 5120;
constexpr std::size_t kShort = 5122;
constexpr std::size_t kUnsignedShort = 5123;
constexpr std::size_t kUnsignedInt = 5125;
constexpr std::size_t kFloat = 5126;

struct MeshDocument {
  std::vector<JsonObject> accessors, views;
  std::size_t materials = 0;
  std::size_t variants = 0;   ///< number of variants of KHR_materials_variants
  bool is_quantized = false;  ///< whether KHR_mesh_quantization is used
  Notes& notes;
};

bool begins_with(const std::string& name, const std::string& prefix) {
  return name.compare(0, prefix.size(), prefix) == 0;
}

/// Returns the accessor types allowed for an attribute; none if the loader does not read it.
std::vector<std::string> allowed_types(const std::string& name) {
  if (name == "POSITION" || name == "NORMAL") {
    return {"VEC3"};
  }
  if (name == "TANGENT" || begins_with(name, "JOINTS_") || begins_with(name, "WEIGHTS_")) {
    return {"VEC4"};
  }
  if (begins_with(name, "TEXCOORD_")) {
    return {"VEC2"};
  }
  return begins_with(name, "COLOR_") ? std::vector<std::string>{"VEC3", "VEC4"}
                                     : std::vector<std::string>();
}

/// Returns whether glTF 2.0 (3.7.2.1) or KHR_mesh_quantization allows an attribute's components.
bool is_component_allowed(const std::string& name, std::size_t component, bool is_normalized,
                          bool is_quantized) {
  const bool is_integer = component >= kByte && component <= kUnsignedShort;
  const bool is_unsigned = is_integer && is_unsigned_component(component);
  if (begins_with(name, "JOINTS_")) {
    return is_unsigned;
  }
  if (component == kFloat) {
    return true;
  }
  if (begins_with(name, "WEIGHTS_") || begins_with(name, "COLOR_")) {
    return is_unsigned && is_normalized;
  }
  if (name == "NORMAL" || name == "TANGENT") {
    return is_quantized && is_normalized && (component == kByte || component == kShort);
  }
  if (begins_with(name, "TEXCOORD_")) {
    return (is_unsigned && is_normalized) || (is_quantized && is_integer);
  }
  return is_quantized && is_integer;
}

void check_format(const std::string& name, const JsonObject& accessor, const std::string& place,
                  bool is_quantized) {
  const std::vector<std::string> types = allowed_types(name);
  if (types.empty()) {
    return;
  }
  const std::string type = accessor.required_text("type");
  require(std::find(types.begin(), types.end(), type) != types.end(), place, ": ", name,
          " is of type ", type, ", expected ", types.front());
  const std::size_t component = accessor.required_whole_number("componentType");
  const bool is_normalized = accessor.flag("normalized").value_or(false);
  require(is_component_allowed(name, component, is_normalized, is_quantized), place, ": ", name,
          " has ", is_normalized ? "normalised " : "", "components of type ", component,
          ", expected one that glTF allows it");
}

/// Checks that an attribute's elements begin at multiples of four bytes (glTF 2.0, 3.6.2.4).
void check_alignment(const std::string& name, const JsonObject& accessor, const std::string& place,
                     const MeshDocument& document) {
  const auto view = accessor.index("bufferView", document.views.size());
  const auto packed = packed_stride(accessor);
  if (!view || !packed) {
    return;
  }
  const std::size_t stride = document.views[*view].whole_number("byteStride").value_or(*packed);
  require(accessor.whole_number("byteOffset").value_or(0) % 4 == 0 && stride % 4 == 0, place, ": ",
          name, " is not aligned, expected a byteOffset and a stride that are multiples of 4");
}

void check_attributes(const JsonObject& attributes, const MeshDocument& document) {
  const std::vector<JsonObject>& accessors = document.accessors;
  std::optional<std::size_t> vertices;
  for (const std::string& name : attributes.keys()) {
    const JsonObject& accessor = accessors[attributes.required_index(name, accessors.size())];
    const std::size_t count = accessor.required_whole_number("count");
    require(vertices.value_or(count) == count, attributes.place(), ": ", name, " has ", count,
            " elements, expected ", vertices.value_or(0), " as the other attributes have");
    vertices = count;
    require(accessor.required_whole_number("componentType") != kUnsignedInt, attributes.place(),
            ": ", name, " has components of type ", kUnsignedInt, ", which is for indices alone");
    check_format(name, accessor, attributes.place(), document.is_quantized);
    check_alignment(name, accessor, attributes.place(), document);
  }
}

/// Checks that a buffer view has a byteStride if several attribute accessors share it.
void check_sharing(const JsonObject& attributes, const MeshDocument& document,
                   std::map<std::size_t, std::size_t>& accessor_of_view) {
  for (const std::string& name : attributes.keys()) {
    const std::size_t index = attributes.required_index(name, document.accessors.size());
    const auto view = document.accessors[index].index("bufferView", document.views.size());
    if (!view || document.views[*view].has("byteStride") ||
        document.views[*view].has("extensions")) {
      continue;
    }
    const std::size_t first = accessor_of_view.try_emplace(*view, index).first->second;
    require(first == index, attributes.place(), ": ", name, " is in bufferViews[", *view,
            "] as accessors[", first, "] is, expected a byteStride there");
  }
}

void check_indices(const JsonObject& primitive, const MeshDocument& document) {
  const auto indices = primitive.index("indices", document.accessors.size());
  if (!indices) {
    return;
  }
  const JsonObject& accessor = document.accessors[*indices];
  require(accessor.required_text("type") == "SCALAR" &&
              is_unsigned_component(accessor.required_whole_number("componentType")),
          primitive.place(), ": indices is accessors[", *indices,
          "] of another type, expected unsigned SCALAR");
  require_packed(accessor, document.views, primitive.place() + ": indices", document.notes);
}

/// Checks a morph target: each attribute that it displaces exists in the primitive, in equal count.
void check_target(const JsonObject& target, const JsonObject& attributes,
                  const MeshDocument& document) {
  const std::vector<JsonObject>& accessors = document.accessors;
  for (const std::string& name : target.keys()) {
    const JsonObject& accessor = accessors[target.required_index(name, accessors.size())];
    require(attributes.has(name), target.place(), ": moves ", name,
            ", expected an attribute that the primitive has");
    const JsonObject& moved = accessors[attributes.required_index(name, accessors.size())];
    const std::size_t count = accessor.required_whole_number("count");
    const std::size_t expected = moved.required_whole_number("count");
    require(count == expected, target.place(), ": ", name, " has ", count, " elements, expected ",
            expected, " as the attribute has");
    // A tangent's displacement has no handedness.
    check_format(name == "TANGENT" ? "NORMAL" : name, accessor, target.place(),
                 document.is_quantized);
    check_alignment(name, accessor, target.place(), document);
  }
}

/// Checks the indices of KHR_materials_variants, although the extension is not supported.
void check_variants(const JsonObject& primitive, const MeshDocument& document) {
  const auto extension = primitive.extension("KHR_materials_variants");
  if (!extension) {
    return;
  }
  for (const JsonObject& mapping : extension->objects("mappings")) {
    mapping.required_index("material", document.materials);
    mapping.indices("variants", document.variants);
  }
}

void check_primitive(const JsonObject& primitive, const MeshDocument& document) {
  primitive.index("material", document.materials);
  check_variants(primitive, document);
  const std::size_t mode = primitive.whole_number("mode").value_or(4);
  require(mode <= 6, primitive.place(), ": mode is ", mode, ", expected 0 to 6");
  check_indices(primitive, document);
  const JsonObject attributes = primitive.required_object("attributes");
  check_attributes(attributes, document);
  for (const JsonObject& target : primitive.objects("targets")) {
    check_target(target, attributes, document);
  }
}

}  // namespace

void check_meshes(const JsonObject& root, Notes& notes) {
  const std::vector<std::string> used = root.texts("extensionsUsed");
  const std::vector<std::string> required = root.texts("extensionsRequired");
  const auto names = [](const std::vector<std::string>& list) {
    return std::find(list.begin(), list.end(), "KHR_mesh_quantization") != list.end();
  };
  const auto variants = root.extension("KHR_materials_variants");
  const MeshDocument document{.accessors = root.objects("accessors"),
                              .views = root.objects("bufferViews"),
                              .materials = root.objects("materials").size(),
                              .variants = variants ? variants->objects("variants").size() : 0,
                              .is_quantized = names(used) || names(required),
                              .notes = notes};
  std::map<std::size_t, std::size_t> accessor_of_view;
  for (const JsonObject& mesh : root.objects("meshes")) {
    const std::vector<JsonObject> primitives = mesh.objects("primitives");
    require(!primitives.empty(), mesh.place(), ": has no primitives, expected at least one");
    for (const JsonObject& primitive : primitives) {
      check_primitive(primitive, document);
      check_sharing(primitive.required_object("attributes"), document, accessor_of_view);
      for (const JsonObject& target : primitive.objects("targets")) {
        check_sharing(target, document, accessor_of_view);
      }
    }
  }
}

}  // namespace synth
