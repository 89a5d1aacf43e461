#include "synth/gltf_document/check_motion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "synth/gltf_document/check_buffers.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr std::size_t kFloatType = 5126;

struct AnimatedDocument {
  std::vector<JsonObject> accessors, views, nodes;
  std::size_t lights = 0;
  std::size_t materials = 0;
  std::vector<std::size_t> target_counts;  ///< number of morph targets of each mesh
  Notes& notes;
};

/// Returns the number of morph targets of the node's mesh; 0 without a mesh.
std::size_t targets_of(const JsonObject& node, const AnimatedDocument& document) {
  const std::optional<std::size_t> mesh = node.index("mesh", document.target_counts.size());
  return mesh ? document.target_counts[*mesh] : 0;
}

std::size_t count_of(const JsonObject& accessor) {
  return accessor.required_whole_number("count");
}

/// Checks that components are floats or normalised integers, which represent fractions.
void require_fractions(const JsonObject& accessor, const std::string& place) {
  const std::size_t component = accessor.required_whole_number("componentType");
  const bool is_short_integer = component >= 5120 && component <= 5123;
  const bool is_fraction =
      component == kFloatType || (is_short_integer && accessor.flag("normalized").value_or(false));
  require(is_fraction, place, ": has components of type ", component,
          ", expected float or normalised integers");
}

/// Returns the number of morph targets of a mesh; throws if its primitives differ in it.
std::size_t target_count(const JsonObject& mesh) {
  const std::vector<JsonObject> primitives = mesh.objects("primitives");
  std::optional<std::size_t> targets;
  for (const JsonObject& primitive : primitives) {
    const std::size_t count = primitive.objects("targets").size();
    require(targets.value_or(count) == count, primitive.place(), ": has ", count,
            " targets, expected ", targets.value_or(0), " as the mesh's first primitive has");
    targets = count;
  }
  return targets.value_or(0);
}

/// Returns the number of morph targets of a mesh; throws if its weights, if any, are not as many.
std::size_t checked_target_count(const JsonObject& mesh) {
  const std::size_t targets = target_count(mesh);
  const std::vector<double> weights = mesh.all_numbers("weights");
  require(weights.empty() || weights.size() == targets, mesh.place(), ": has ", weights.size(),
          " weights, expected one for each of its ", targets, " targets");
  return targets;
}

std::size_t outputs_per_key(const std::string& path, const JsonObject& node,
                            const AnimatedDocument& document) {
  if (path != "weights") {
    return 1;
  }
  const std::size_t targets = targets_of(node, document);
  require(targets > 0, node.place(),
          ": an animation moves its weights, expected a mesh with morph targets");
  return targets;
}

void check_output(const std::string& path, const JsonObject& sampler, std::size_t values_per_key,
                  const std::vector<JsonObject>& accessors) {
  const JsonObject& input = accessors[sampler.required_index("input", accessors.size())];
  const JsonObject& output = accessors[sampler.required_index("output", accessors.size())];
  const std::string place = sampler.place() + ": output";
  const bool is_spline = sampler.text("interpolation").value_or("LINEAR") == "CUBICSPLINE";
  const std::size_t rows = is_spline ? 3 : 1;
  require(count_of(output) % (rows * values_per_key) == 0 &&
              count_of(output) / (rows * values_per_key) == count_of(input),
          place, ": has ", count_of(output), " elements, expected ", rows * values_per_key,
          " for each of the ", count_of(input), " keys");
  if (path == "rotation" || path == "weights") {
    require_element_type(output, path == "rotation" ? "VEC4" : "SCALAR", place);
    require_fractions(output, place);
  } else if (path == "intensity" || path == "emissiveStrength") {
    require_element_type(output, "SCALAR", place);
    require_float_components(output, place);
  } else {
    require_element_type(output, "VEC3", place);
    require_float_components(output, place);
  }
}

void check_sampler(const JsonObject& sampler, const AnimatedDocument& document) {
  const std::vector<JsonObject>& accessors = document.accessors;
  const JsonObject& input = accessors[sampler.required_index("input", accessors.size())];
  const JsonObject& output = accessors[sampler.required_index("output", accessors.size())];
  require_element_type(input, "SCALAR", sampler.place() + ": input");
  require_float_components(input, sampler.place() + ": input");
  require_packed(input, document.views, sampler.place() + ": input", document.notes);
  require_packed(output, document.views, sampler.place() + ": output", document.notes);
  const std::string interpolation = sampler.text("interpolation").value_or("LINEAR");
  require(interpolation == "LINEAR" || interpolation == "STEP" || interpolation == "CUBICSPLINE",
          sampler.place(), ": interpolation is ", interpolation,
          ", expected LINEAR, STEP or CUBICSPLINE");
  require(interpolation != "CUBICSPLINE" || count_of(input) >= 2, sampler.place(),
          ": a cubic spline has one key, expected two or more");
}

/// A ChannelTarget is what an animation's channel changes.
struct ChannelTarget {
  std::string element;              ///< its name in messages, like "nodes[3]"
  std::optional<std::size_t> node;  ///< if it is a node
  std::string path;
};

/// Returns the target of a channel that names an element by its JSON pointer; nothing if this is
/// not supported. Throws if there is no such element.
std::optional<ChannelTarget> pointed_target(const JsonObject& target,
                                            const AnimatedDocument& document) {
  const std::optional<JsonObject> extension = target.extension(kAnimationPointerExtension);
  if (!extension) {
    add_note(document.notes, vo::concat("animation channels of path pointer without ",
                                        kAnimationPointerExtension, " are left out"));
    return std::nullopt;
  }
  const std::string pointer = extension->required_text("pointer");
  const std::optional<AnimationPointer> named = parse_animation_pointer(pointer);
  if (!named) {
    add_note(document.notes,
             vo::concat("animation channels of ", kAnimationPointerExtension,
                        " at anything but nodes, brightness of lights and emission are left out"));
    return std::nullopt;
  }
  const std::size_t count = named->array == "nodes"    ? document.nodes.size()
                            : named->array == "lights" ? document.lights
                                                       : document.materials;
  require(named->index < count, target.place(), ": the pointer ", pointer, " names one of ", count,
          " ", named->array, ", expected an index below ", count);
  ChannelTarget pointed{vo::concat(named->array, "[", named->index, "]"), std::nullopt,
                        std::string(named->property)};
  if (named->array == "nodes") {
    pointed.node = named->index;
  }
  return pointed;
}

/// Returns what a channel changes; nothing if this is not supported.
std::optional<ChannelTarget> channel_target(const JsonObject& target,
                                            const AnimatedDocument& document) {
  const std::string path = target.required_text("path");
  const std::optional<std::size_t> node = target.index("node", document.nodes.size());
  if (path == "pointer") {
    return pointed_target(target, document);
  }
  if (!node) {
    return std::nullopt;
  }
  require(path == "translation" || path == "rotation" || path == "scale" || path == "weights",
          target.place(), ": path is ", path,
          ", expected translation, rotation, scale, weights or pointer");
  return ChannelTarget{vo::concat("nodes[", *node, "]"), node, path};
}

/// Checks the node that a channel moves, and returns the numbers of its values at each key.
std::size_t check_moved_node(const JsonObject& target, const ChannelTarget& changed,
                             const AnimatedDocument& document) {
  if (!changed.node) {
    return 1;
  }
  const JsonObject& moving = document.nodes[*changed.node];
  require(changed.path == "weights" || !moving.has("matrix"), target.place(), ": moves ",
          changed.element,
          ", which has a matrix, expected a node with translation, rotation and scale");
  return outputs_per_key(changed.path, moving, document);
}

void check_animation(const JsonObject& animation, const AnimatedDocument& document) {
  const std::vector<JsonObject> samplers = animation.objects("samplers");
  for (const JsonObject& sampler : samplers) {
    check_sampler(sampler, document);
  }
  std::set<std::pair<std::string, std::string>> moved;
  for (const JsonObject& channel : animation.objects("channels")) {
    const std::size_t sampler = channel.required_index("sampler", samplers.size());
    const JsonObject target = channel.required_object("target");
    const std::optional<ChannelTarget> changed = channel_target(target, document);
    if (!changed) {
      continue;
    }
    require(moved.insert({changed->element, changed->path}).second, target.place(), ": moves the ",
            changed->path, " of ", changed->element, " a second time, expected once");
    check_output(changed->path, samplers[sampler], check_moved_node(target, *changed, document),
                 document.accessors);
  }
}

void check_node(const JsonObject& node, const AnimatedDocument& document) {
  const std::vector<double> weights = node.all_numbers("weights");
  const std::size_t targets = targets_of(node, document);
  require(weights.empty() || weights.size() == targets, node.place(), ": has ", weights.size(),
          " weights, expected one for each of the ", targets, " targets of its mesh");
}

std::optional<std::size_t> index_in(std::string_view text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(index)
                                                                  : std::nullopt;
}

/// A PointerPattern is what a supported pointer has before and after the index of an element.
struct PointerPattern {
  std::string_view before;
  std::string_view array;
  std::string_view after;
  std::string_view property;
};

constexpr std::array<PointerPattern, 8> kPointerPatterns = {
    {{"/extensions/KHR_lights_punctual/lights/", "lights", "/intensity", "intensity"},
     {"/extensions/KHR_lights_punctual/lights/", "lights", "/color", "color"},
     {"/materials/", "materials", "/emissiveFactor", "emissiveFactor"},
     {"/materials/", "materials", "/extensions/KHR_materials_emissive_strength/emissiveStrength",
      "emissiveStrength"},
     {"/nodes/", "nodes", "/translation", "translation"},
     {"/nodes/", "nodes", "/rotation", "rotation"},
     {"/nodes/", "nodes", "/scale", "scale"},
     {"/nodes/", "nodes", "/weights", "weights"}}};

}  // namespace

std::optional<AnimationPointer> parse_animation_pointer(std::string_view pointer) {
  for (const auto& [before, array, after, property] : kPointerPatterns) {
    if (pointer.size() <= before.size() + after.size() || !pointer.starts_with(before) ||
        !pointer.ends_with(after)) {
      continue;
    }
    const std::string_view middle =
        pointer.substr(before.size(), pointer.size() - before.size() - after.size());
    if (const std::optional<std::size_t> index = index_in(middle)) {
      return AnimationPointer{array, *index, property};
    }
  }
  return std::nullopt;
}

void check_motion(const JsonObject& root, Notes& notes) {
  const std::optional<JsonObject> lights = root.extension("KHR_lights_punctual");
  AnimatedDocument document{root.objects("accessors"),
                            root.objects("bufferViews"),
                            root.objects("nodes"),
                            lights ? lights->objects("lights").size() : 0,
                            root.objects("materials").size(),
                            {},
                            notes};
  for (const JsonObject& mesh : root.objects("meshes")) {
    document.target_counts.push_back(checked_target_count(mesh));
  }
  for (const JsonObject& node : document.nodes) {
    check_node(node, document);
  }
  for (const JsonObject& animation : root.objects("animations")) {
    check_animation(animation, document);
  }
}

}  // namespace synth
