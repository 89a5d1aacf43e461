#include "synth/gltf_document/check_instancing.h"

#include <optional>
#include <string>
#include <vector>

#include "synth/gltf_document/check_buffers.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// Checks an instancing attribute's types; only rotations may be normalised bytes or shorts.
void check_attribute(const JsonObject& accessor, const std::string& name,
                     const std::string& place) {
  constexpr std::size_t kByte = 5120;
  constexpr std::size_t kShort = 5122;
  const bool is_rotation = name == kInstancingAttributes[1];
  require_element_type(accessor, is_rotation ? "VEC4" : "VEC3", place);
  const std::size_t component = accessor.required_whole_number("componentType");
  const bool is_short = component == kByte || component == kShort;
  if (!is_rotation || !is_short || !accessor.flag("normalized").value_or(false)) {
    require_float_components(accessor, place);
  }
}

void check_attributes(const JsonObject& attributes, const std::vector<JsonObject>& accessors) {
  std::optional<std::size_t> instances;
  for (const std::string name : kInstancingAttributes) {
    const std::optional<std::size_t> index = attributes.index(name, accessors.size());
    if (!index) {
      continue;
    }
    const std::string place = attributes.place() + ": " + name;
    check_attribute(accessors[*index], name, place);
    const std::size_t count = accessors[*index].required_whole_number("count");
    require(instances.value_or(count) == count, place, " has ", count, " elements, expected ",
            instances.value_or(0), " as the other attributes have");
    instances = count;
  }
  require(instances.has_value(), attributes.place(),
          ": has none of TRANSLATION, ROTATION and SCALE, expected one or more");
}

}  // namespace

void check_instancing(const JsonObject& root) {
  const std::vector<JsonObject> accessors = root.objects("accessors");
  for (const JsonObject& node : root.objects("nodes")) {
    if (const auto instancing = node.extension(kInstancingExtension)) {
      check_attributes(instancing->required_object("attributes"), accessors);
    }
  }
}

}  // namespace synth
