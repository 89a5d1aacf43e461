#pragma once

#include <string>
#include <vector>

namespace synth {

enum class Interpolation { step, linear, cubic_spline };

/// Numbers over time. Before the first key and after the last it keeps their values.
struct AnimationCurve {
  Interpolation interpolation = Interpolation::linear;
  int width = 1;                   ///< numbers per value
  std::vector<float> times;        ///< s, of the keys, increasing, at least one
  std::vector<float> values;       ///< key by key; `cubic_spline`: in-tangent, value, out-tangent
  bool holds_quaternions = false;  ///< x, y, z, w: `linear` takes the shorter arc
};

enum class AnimatedProperty { translation, rotation, scale, weights };

struct AnimationChannel {
  int node = 0;  ///< of SceneMotion::nodes
  AnimatedProperty property = AnimatedProperty::translation;
  AnimationCurve curve;
};

struct Animation {
  std::string name;
  double duration = 0;  ///< s, the time of its last key
  std::vector<AnimationChannel> channels;
};

/// The curve's value at a time, s; quaternions are unit.
std::vector<double> value_at(const AnimationCurve& curve, double time);

/// Whether it has the same value at all times.
bool is_constant(const AnimationCurve& curve);

}  // namespace synth
