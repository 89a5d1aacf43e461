#include "synth/camera/make_renderer.h"

#include "synth/rasterization/rasterizer.h"
#include "synth/ray_tracing/ray_tracer.h"

namespace synth {

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const RenderOptions& options) {
  options.validate();
  return options.kind == RendererKind::rasterizer ? make_rasterizer(scene, options)
                                                  : make_ray_tracer(scene, options);
}

std::unique_ptr<Renderer> make_renderer(const SceneDuring& during, const RenderOptions& options) {
  options.validate();
  return options.kind == RendererKind::rasterizer ? make_rasterizer(during.now, options)
                                                  : make_ray_tracer(during, options);
}

}  // namespace synth
