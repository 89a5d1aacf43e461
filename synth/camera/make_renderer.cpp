#include "synth/camera/make_renderer.h"

#include "synth/rasterization/rasterizer.h"
#include "synth/ray_tracing/ray_tracer.h"
#include "vo/core/error.h"

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

void require_drawable(const Scene& scene, const RenderOptions& options) {
  if (options.kind == RendererKind::rasterizer) {
    require_rasterizable(scene);
  }
}

void require_drawable(const vo::CameraModel& camera, const Shutter& shutter,
                      const RenderOptions& options) {
  if (options.kind == RendererKind::rasterizer) {
    require_rasterizable(camera, shutter);
  }
}

std::vector<std::string> notes_on_materials(const Scene& scene, const RenderOptions& options) {
  const bool draws_all =
      options.kind == RendererKind::ray_tracer && options.mode == RenderMode::path;
  if (draws_all || options.mode == RenderMode::depth) {
    return {};
  }
  std::string names;
  for (const Material& material : scene.materials) {
    if (material.layers.any()) {
      names += vo::concat(names.empty() ? "" : ", ", "\"", material.name, "\"");
    }
  }
  if (names.empty()) {
    return {};
  }
  return {vo::concat("transmission is drawn opaque and clear coats are left out, of the materials ",
                     names, "; --mode path of the ray tracer draws them")};
}

}  // namespace synth
