#pragma once

#include <cstdint>

#include "synth/path/camera_path.h"

namespace synth {

/// The amplitudes and the frequency band of hand shake; none by default.
struct ShakeOptions {
  double amplitude = 0;      ///< m, root mean square along each of the camera's axes
  double amplitude_deg = 0;  ///< deg, root mean square about each of the camera's axes
  double low_hz = 0.5;       ///< Hz, lowest frequency
  double high_hz = 8;        ///< Hz, highest frequency
  std::uint64_t seed = 0;

  bool moves() const { return amplitude > 0 || amplitude_deg > 0; }
  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, ShakeOptions& options) {
  visit("amplitude", options.amplitude, "along each of the camera's axes, rms, m");
  visit("amplitude_deg", options.amplitude_deg, "about each of the camera's axes, rms, deg");
  visit("low_hz", options.low_hz, "lowest frequency of the shake, Hz");
  visit("high_hz", options.high_hz, "highest frequency of the shake, Hz");
  visit("seed", options.seed, "another seed is another shake of the same kind");
}

/// Returns the path with hand shake: T_world_camera(t) T_camera_shaken(t). Along and about each
/// axis the shake is a sum of sinusoids of random phase, one in each of sixteen equal parts of the
/// band, with amplitudes in inverse proportion to their frequency: the spectrum of its speed is
/// flat. The shake is infinitely differentiable.
CameraPath with_hand_shake(CameraPath path, const ShakeOptions& options);

}  // namespace synth
