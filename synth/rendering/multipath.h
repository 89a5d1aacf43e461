#pragma once

#include <array>
#include <cstdint>
#include <utility>

namespace synth {

/// Where the lamp of a time-of-flight camera shines, evenly: into the field of view alone, as such
/// lamps are made, or in all directions.
enum class LampField { view, all };

constexpr auto enum_names(LampField) {
  return std::array{std::pair{LampField::view, "view"}, std::pair{LampField::all, "all"}};
}

/// Multipath interference of a continuous-wave time-of-flight camera, whose lamp is where the
/// camera is and sends light that is modulated at one frequency f, Hz. A pixel sums the phasors of
/// all light that reaches it,
///     sum over paths of amplitude exp(2 pi i f L / c),  L the length from the lamp to the camera,
/// and measures L / 2 as c / (4 pi f) times the phase of the sum (Fuchs, Multipath interference
/// compensation in time-of-flight camera images, ICPR 2010; Jimenez et al., Modelling and
/// correction of multipath interference in time of flight cameras, CVPR 2012). The turn of the
/// phase that is nearest to that of the straight path is measured, as cameras of several
/// frequencies find it. Cameras that notice the interference have no depth there, `max_error`.
struct MultipathOptions {
  double frequency = 0;  ///< Hz, of the modulation; 0 = light takes the straight path alone
  int samples = 8;       ///< paths that are followed from each pixel
  int bounces = 2;       ///< most surfaces that light meets before the one that the pixel sees
  LampField lamp = LampField::view;
  int radius = 4;        ///< px, of the window in which the paths of one surface are averaged
  double max_error = 0;  ///< m, along the ray; depth that errs by more is lost; 0 = none is
  std::uint64_t seed = 0;

  bool is_on() const { return frequency > 0; }
  double wave_number() const;  ///< rad/m, phase per length of the way of the modulated light
  void validate() const;       ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, MultipathOptions& options) {
  visit("frequency", options.frequency,
        "of a time-of-flight camera's light, Hz; 0: no light comes by way of other surfaces");
  visit("samples", options.samples, "paths of light followed from each pixel");
  visit("bounces", options.bounces, "surfaces that light meets before the one that is seen, most");
  visit("lamp", options.lamp, "where the lamp shines: what the image shows, or all around");
  visit("radius", options.radius, "of the window in which a surface's paths are averaged, px");
  visit("max_error", options.max_error, "depth that errs by more is lost, m; 0: none is");
  visit("seed", options.seed, "of the directions");
}

}  // namespace synth
