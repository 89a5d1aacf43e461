#include "synth/path/hand_shake.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/hash.h"

namespace synth {
namespace {

constexpr std::size_t kParts = 16;

struct Sinusoid {
  double amplitude = 0;
  double frequency = 0;  ///< rad/s
  double phase = 0;      ///< rad
};

using Wobble = std::array<Sinusoid, kParts>;

enum Draw : std::uint64_t { frequency_draw = 1, phase_draw = 2 };

/// Returns a sum of sinusoids of mean square 1; each has half of its squared amplitude.
Wobble make_wobble(const ShakeOptions& options, std::uint64_t axis) {
  Wobble wobble;
  double mean_square = 0;
  for (std::size_t i = 0; i < kParts; ++i) {
    const double share =
        (static_cast<double>(i) + vo::random_uniform({options.seed, axis, frequency_draw, i})) /
        kParts;
    const double hz = options.low_hz + (options.high_hz - options.low_hz) * share;
    wobble.at(i) = {1 / hz, 2 * std::numbers::pi * hz,
                    2 * std::numbers::pi * vo::random_uniform({options.seed, axis, phase_draw, i})};
    mean_square += 1 / (2 * hz * hz);
  }
  for (Sinusoid& sinusoid : wobble) {
    sinusoid.amplitude /= std::sqrt(mean_square);
  }
  return wobble;
}

double value(const Wobble& wobble, double time) {
  double sum = 0;
  for (const Sinusoid& s : wobble) {
    sum += s.amplitude * std::sin(s.frequency * time + s.phase);
  }
  return sum;
}

}  // namespace

void ShakeOptions::validate() const {
  vo::require(amplitude >= 0 && std::isfinite(amplitude),
              "shake.amplitude: expected 0 m or above, got ", amplitude);
  vo::require(amplitude_deg >= 0 && amplitude_deg < 45,
              "shake.amplitude_deg: expected at least 0 and below 45, got ", amplitude_deg);
  vo::require(low_hz > 0 && low_hz < high_hz && std::isfinite(high_hz),
              "shake: expected 0 < low_hz < high_hz, got ", low_hz, " and ", high_hz);
}

CameraPath with_hand_shake(CameraPath path, const ShakeOptions& options) {
  options.validate();
  std::array<Wobble, 6> wobbles;  // three of translation, three of rotation
  for (std::size_t axis = 0; axis < wobbles.size(); ++axis) {
    wobbles.at(axis) = make_wobble(options, axis);
  }
  return [path = std::move(path), wobbles, amplitude = options.amplitude,
          angle = options.amplitude_deg * std::numbers::pi / 180](double time) {
    Eigen::Vector3d translation;
    vo::Vector6d turn = vo::Vector6d::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      translation[axis] = amplitude * value(wobbles.at(static_cast<std::size_t>(axis)), time);
      turn[axis + 3] = angle * value(wobbles.at(static_cast<std::size_t>(axis) + 3), time);
    }
    return path(time) * vo::SE3(vo::SE3::exp(turn).rotation(), translation);
  };
}

}  // namespace synth
