#include "synth/gltf/animation.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "synth/gltf_document/notes.h"
#include "synth/gltf_model/accessor.h"
#include "synth/gltf_model/select.h"
#include "synth/scene/scene.h"
#include "vo/core/error.h"
#include "vo/geometry/unit_quaternion.h"

namespace synth {
namespace {

using vo::require;

AnimatedProperty read_property(const std::string& path) {
  return path == "translation" ? AnimatedProperty::translation
         : path == "rotation"  ? AnimatedProperty::rotation
         : path == "scale"     ? AnimatedProperty::scale
                               : AnimatedProperty::weights;
}

Interpolation read_interpolation(const std::string& name) {
  return name == "STEP"          ? Interpolation::step
         : name == "CUBICSPLINE" ? Interpolation::cubic_spline
                                 : Interpolation::linear;
}

void require_increasing(const std::vector<float>& times, const std::string& place) {
  require(times.front() >= 0, place, ": its first key is at ", times.front(),
          " s, expected 0 or later");
  for (std::size_t i = 1; i < times.size(); ++i) {
    require(times[i] > times[i - 1], place, ": key ", i, " is at ", times[i], " s after one at ",
            times[i - 1], " s, expected increasing times");
  }
}

void require_rotations(const AnimationCurve& curve, const std::string& place) {
  const std::size_t rows = curve.values.size() / 4;
  const bool has_tangents = curve.interpolation == Interpolation::cubic_spline;
  for (std::size_t row = has_tangents ? 1 : 0; row < rows; row += has_tangents ? 3 : 1) {
    const Eigen::Map<const Eigen::Vector4f> rotation(curve.values.data() + 4 * row);
    require(vo::is_nearly_unit(rotation), place, ": element ", row,
            " is not of length 1, expected a unit quaternion");
  }
}

/// Reads an animation sampler and checks those of its times and values that the file holds.
AnimationCurve read_curve(const GltfModel& model, const tinygltf::AnimationSampler& sampler,
                          AnimatedProperty property, const std::string& place) {
  AnimationCurve curve;
  curve.interpolation = read_interpolation(sampler.interpolation);
  curve.times = read_numbers(model.content, sampler.input, place + ": input");
  if (holds_data(model.content, sampler.input)) {
    require_increasing(curve.times, place);
  }
  curve.values = read_numbers(model.content, sampler.output, place + ": output");
  const std::size_t rows =
      curve.times.size() * (curve.interpolation == Interpolation::cubic_spline ? 3 : 1);
  curve.width = static_cast<int>(curve.values.size() / rows);
  curve.holds_quaternions = property == AnimatedProperty::rotation;
  if (curve.holds_quaternions && holds_data(model.content, sampler.output)) {
    require_rotations(curve, place + ": output");
  }
  return curve;
}

std::size_t memory_of(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler) {
  constexpr std::size_t kKeyBytes = 4 * sizeof(float);
  return kKeyBytes *
         (model.accessors[at(sampler.input)].count + model.accessors[at(sampler.output)].count);
}

Animation read_animation(GltfReading& reading, int index, const NodeForest& forest) {
  const GltfModel& model = reading.model;
  const tinygltf::Animation& source = model.content.animations[at(index)];
  Animation animation;
  animation.name = source.name;
  for (const tinygltf::AnimationChannel& channel : source.channels) {
    if (channel.target_node == kNone || channel.target_path == "pointer") {
      add_note(reading.notes, "animation channels that move no node are left out");
      continue;
    }
    const std::string place =
        model.place("animations", index) + ".samplers[" + std::to_string(channel.sampler) + ']';
    const tinygltf::AnimationSampler& sampler = source.samplers[at(channel.sampler)];
    reading.budget.take(memory_of(model.content, sampler), place);
    AnimationChannel added;
    added.node = forest.of_gltf[at(channel.target_node)];
    added.property = read_property(channel.target_path);
    added.curve = read_curve(model, sampler, added.property, place);
    if (!holds_data(model.content, sampler.input) || !holds_data(model.content, sampler.output)) {
      add_note(reading.notes, "animation channels without data are left out");
      continue;
    }
    animation.duration = std::max<double>(animation.duration, added.curve.times.back());
    animation.channels.push_back(std::move(added));
  }
  return animation;
}

using Targets = std::set<std::pair<int, AnimatedProperty>>;

Targets targets_of(const Animation& animation) {
  Targets targets;
  for (const AnimationChannel& channel : animation.channels) {
    targets.insert({channel.node, channel.property});
  }
  return targets;
}

bool overlap(const Targets& a, const Targets& b) {
  return std::any_of(a.begin(), a.end(), [&](const auto& target) { return b.count(target) > 0; });
}

/// Returns, in the file's order, the animations that move nothing that an earlier one moves.
std::vector<Animation> those_that_fit_together(std::vector<Animation> animations, Notes& notes) {
  std::vector<Animation> fitting;
  Targets taken;
  for (Animation& animation : animations) {
    const Targets targets = targets_of(animation);
    if (overlap(targets, taken)) {
      add_note(notes, "animations that move what an earlier one moves do not play");
      continue;
    }
    taken.insert(targets.begin(), targets.end());
    fitting.push_back(std::move(animation));
  }
  return fitting;
}

}  // namespace

std::vector<Animation> read_animations(GltfReading& reading, const NodeForest& forest,
                                       const std::string& wanted) {
  const GltfModel& model = reading.model;
  std::vector<std::string> names;
  for (const tinygltf::Animation& animation : model.content.animations) {
    names.push_back(animation.name);
  }
  std::vector<Animation> animations;
  const std::vector<int> chosen = select_animations(wanted, names, model.path.string());
  animations.reserve(chosen.size());
  for (const int index : chosen) {
    animations.push_back(read_animation(reading, index, forest));
  }
  return those_that_fit_together(std::move(animations), reading.notes);
}

}  // namespace synth
