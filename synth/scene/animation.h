#pragma once

#include <limits>
#include <string>
#include <vector>

namespace synth {

enum class Interpolation { step, linear, cubic_spline };

/// A keyframed curve of values over time; constant before its first and after its last key.
struct AnimationCurve {
  Interpolation interpolation = Interpolation::linear;
  int width = 1;                   ///< numbers per value
  std::vector<float> times;        ///< s, key times, increasing, at least one
  std::vector<float> values;       ///< by key; `cubic_spline`: in-tangent, value, out-tangent
  bool holds_quaternions = false;  ///< as x, y, z, w; `linear` slerps along the shorter arc
};

enum class AnimatedProperty { translation, rotation, scale, weights };

struct AnimationChannel {
  int node = 0;  ///< index into SceneMotion::nodes
  AnimatedProperty property = AnimatedProperty::translation;
  AnimationCurve curve;
};

/// The factors of how brightly a light or a surface shines.
enum class BrightnessFactor { light_color, light_strength, emission_color, emission_strength };

/// A curve of one factor, linear RGB or a number, which counts as 0 where it is less.
struct BrightnessChannel {
  BrightnessFactor factor = BrightnessFactor::light_strength;
  int target = 0;  ///< index into Scene::lights or, of an emission, Scene::materials
  AnimationCurve curve;

  bool is_of_light() const {
    return factor == BrightnessFactor::light_color || factor == BrightnessFactor::light_strength;
  }
  bool is_color() const {
    return factor == BrightnessFactor::light_color || factor == BrightnessFactor::emission_color;
  }
};

struct Animation {
  std::string name;
  double duration = 0;  ///< s, time of the animation's last key
  std::vector<AnimationChannel> channels;
  std::vector<BrightnessChannel> brightness;
  double start = 0;  ///< s, scene time at which it begins; before, its first keys count
  double stop =
      std::numeric_limits<double>::infinity();  ///< s, scene time from which it holds still
  bool loops = false;  ///< restarts at its end, whatever SceneMotion::loop says
};

/// Returns the curve's value at a time in s, `width` numbers; quaternions have length 1.
std::vector<double> value_at(const AnimationCurve& curve, double time);

/// Returns whether a curve has one value at all times.
bool is_constant(const AnimationCurve& curve);

}  // namespace synth
