#include "synth/gltf/animation.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "synth/gltf_document/check_motion.h"
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

/// A ChannelTarget is what an animation's channel changes.
struct ChannelTarget {
  int node = kNone;                       ///< glTF's index; kNone where it is no node
  std::string path;                       ///< as a channel of a node names it
  std::optional<AnimationPointer> shine;  ///< of a light or a material

  bool is_brightness() const { return shine.has_value(); }
};

/// Returns what a channel changes; nothing if this is not supported.
std::optional<ChannelTarget> target_of(const tinygltf::AnimationChannel& channel) {
  if (channel.target_path != "pointer") {
    return channel.target_node == kNone
               ? std::nullopt
               : std::optional(ChannelTarget{channel.target_node, channel.target_path, {}});
  }
  const auto extension = channel.target_extensions.find(kAnimationPointerExtension);
  if (extension == channel.target_extensions.end()) {
    return std::nullopt;
  }
  const std::string& pointer = extension->second.Get("pointer").Get<std::string>();
  const std::optional<AnimationPointer> named = parse_animation_pointer(pointer);
  if (!named) {
    return std::nullopt;
  }
  if (named->array == "nodes") {
    return ChannelTarget{static_cast<int>(named->index), std::string(named->property), {}};
  }
  return ChannelTarget{kNone, std::string(named->property), named};
}

void require_brightness(const AnimationCurve& curve, const std::string& place) {
  const bool has_tangents = curve.interpolation == Interpolation::cubic_spline;
  const auto width = static_cast<std::size_t>(curve.width);
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    require((has_tangents && i / width % 3 != 1) || curve.values[i] >= 0, place, ": has ",
            curve.values[i], ", expected brightness of 0 or more");
  }
}

/// Reads an animation sampler and checks those of its times and values that the file holds.
AnimationCurve read_curve(const GltfModel& model, const tinygltf::AnimationSampler& sampler,
                          const ChannelTarget& target, const std::string& place) {
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
  curve.holds_quaternions = target.path == "rotation";
  if (curve.holds_quaternions && holds_data(model.content, sampler.output)) {
    require_rotations(curve, place + ": output");
  }
  if (target.is_brightness()) {
    require_brightness(curve, place + ": output");
  }
  return curve;
}

std::size_t memory_of(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler) {
  constexpr std::size_t kKeyBytes = 4 * sizeof(float);
  return kKeyBytes *
         (model.accessors[at(sampler.input)].count + model.accessors[at(sampler.output)].count);
}

void add_channel(const AnimatedElements& elements, const ChannelTarget& target,
                 AnimationCurve curve, Animation& animation) {
  animation.duration = std::max<double>(animation.duration, curve.times.back());
  if (target.is_brightness()) {
    for (BrightnessChannel& channel :
         brightness_channels(*target.shine, curve, elements.scene, elements.shining)) {
      animation.brightness.push_back(std::move(channel));
    }
    return;
  }
  animation.channels.push_back({.node = elements.forest.of_gltf[at(target.node)],
                                .property = read_property(target.path),
                                .curve = std::move(curve)});
}

Animation read_animation(GltfReading& reading, int index, const AnimatedElements& elements) {
  const GltfModel& model = reading.model;
  const tinygltf::Animation& source = model.content.animations[at(index)];
  Animation animation;
  animation.name = source.name;
  for (const tinygltf::AnimationChannel& channel : source.channels) {
    const std::optional<ChannelTarget> target = target_of(channel);
    if (!target) {
      if (channel.target_path != "pointer") {
        add_note(reading.notes, "animation channels that move no node are left out");
      }
      continue;
    }
    const std::string place =
        model.place("animations", index) + ".samplers[" + std::to_string(channel.sampler) + ']';
    const tinygltf::AnimationSampler& sampler = source.samplers[at(channel.sampler)];
    const std::size_t curves =
        target->is_brightness() ? count_of_targets(*target->shine, elements.shining) : 1;
    reading.budget.take(curves * memory_of(model.content, sampler), place);
    AnimationCurve curve = read_curve(model, sampler, *target, place);
    if (!holds_data(model.content, sampler.input) || !holds_data(model.content, sampler.output)) {
      add_note(reading.notes, "animation channels without data are left out");
      continue;
    }
    add_channel(elements, *target, std::move(curve), animation);
  }
  return animation;
}

/// Targets are what an animation changes: whether it shines, its index and its property.
using Targets = std::set<std::tuple<bool, int, int>>;

Targets targets_of(const Animation& animation) {
  Targets targets;
  for (const AnimationChannel& channel : animation.channels) {
    targets.insert({false, channel.node, static_cast<int>(channel.property)});
  }
  for (const BrightnessChannel& channel : animation.brightness) {
    targets.insert({true, channel.target, static_cast<int>(channel.factor)});
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

std::vector<Animation> read_animations(GltfReading& reading, const AnimatedElements& elements,
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
    animations.push_back(read_animation(reading, index, elements));
  }
  return those_that_fit_together(std::move(animations), reading.notes);
}

}  // namespace synth
