#include "synth/gltf_document/check_motion.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
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

void check_animation(const JsonObject& animation, const AnimatedDocument& document) {
  const std::vector<JsonObject> samplers = animation.objects("samplers");
  for (const JsonObject& sampler : samplers) {
    check_sampler(sampler, document);
  }
  std::set<std::pair<std::size_t, std::string>> moved;
  for (const JsonObject& channel : animation.objects("channels")) {
    const std::size_t sampler = channel.required_index("sampler", samplers.size());
    const JsonObject target = channel.required_object("target");
    const std::string path = target.required_text("path");
    const std::optional<std::size_t> node = target.index("node", document.nodes.size());
    if (!node || path == "pointer") {
      continue;
    }
    require(path == "translation" || path == "rotation" || path == "scale" || path == "weights",
            target.place(), ": path is ", path,
            ", expected translation, rotation, scale or weights");
    require(moved.insert({*node, path}).second, target.place(), ": moves the ", path, " of nodes[",
            *node, "] a second time, expected once");
    const JsonObject& moving = document.nodes[*node];
    require(path == "weights" || !moving.has("matrix"), target.place(), ": moves nodes[", *node,
            "], which has a matrix, expected a node with translation, rotation and scale");
    check_output(path, samplers[sampler], outputs_per_key(path, moving, document),
                 document.accessors);
  }
}

void check_node(const JsonObject& node, const AnimatedDocument& document) {
  const std::vector<double> weights = node.all_numbers("weights");
  const std::size_t targets = targets_of(node, document);
  require(weights.empty() || weights.size() == targets, node.place(), ": has ", weights.size(),
          " weights, expected one for each of the ", targets, " targets of its mesh");
}

}  // namespace

void check_motion(const JsonObject& root, Notes& notes) {
  AnimatedDocument document{
      root.objects("accessors"), root.objects("bufferViews"), root.objects("nodes"), {}, notes};
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
