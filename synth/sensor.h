#pragma once

#include "synth/renderer.h"
#include "vo/core/camera.h"
#include "vo/core/image.h"
#include "vo/core/trajectory.h"

namespace synth {

/// From what a perfect sensor would see to what this one measures. The defaults are perfect.
struct SensorOptions {
  double exposure = 0;      ///< gain from linear radiance to linear 0..1; 0 = metered
  double min_depth = 0.01;  ///< m; nearer surfaces have no depth
  double max_depth = 1000;  ///< m; farther surfaces have no depth

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, SensorOptions& options) {
  visit("exposure", options.exposure, "gain from linear radiance to 0..1; 0 meters the scene once");
  visit("min_depth", options.min_depth, "nearer surfaces have no depth, m");
  visit("max_depth", options.max_depth, "farther surfaces have no depth, m");
}

/// The gain that brings the middle of what the camera sees to 18 % grey, rendered small at eight
/// poses spread over the trajectory; 1 for a scene without lights, whose colours are final.
double meter_exposure(const Scene& scene, const Renderer& renderer, const vo::PinholeCamera& camera,
                      const vo::Trajectory& trajectory);

/// Colour in sRGB, 8 bit. `options.exposure` must be set (not metered).
vo::RgbdFrame measure(const RenderedFrame& ideal, double timestamp, const SensorOptions& options);

}  // namespace synth
