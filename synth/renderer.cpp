#include "synth/renderer.h"

#include <cmath>

#include "synth/ray_tracer.h"
#include "vo/core/error.h"

namespace synth {

void RenderOptions::validate() const {
  constexpr int kMaxSamples = 256;
  vo::require(samples >= 1 && samples <= kMaxSamples, "render: expected samples from 1 to ",
              kMaxSamples, ", got ", samples);
  vo::require(ambient >= 0 && std::isfinite(ambient),
              "render: expected ambient at or above 0, got ", ambient);
}

int RenderOptions::samples_per_edge() const {
  return static_cast<int>(std::ceil(std::sqrt(samples)));
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const RenderOptions& options) {
  options.validate();
  return make_ray_tracer(scene, options);
}

}  // namespace synth
