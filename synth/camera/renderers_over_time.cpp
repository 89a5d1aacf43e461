#include "synth/camera/renderers_over_time.h"

#include "synth/camera/make_renderer.h"
#include "synth/scene/scene_motion.h"

namespace synth {
namespace {

/// A renderer together with the scene that it refers to.
struct Moment {
  Scene scene;
  std::unique_ptr<const Renderer> renderer;
};

/// Returns a renderer of the scene at a time, s, which keeps that scene.
std::shared_ptr<const Renderer> renderer_at(const Scene& scene, double time,
                                            const RenderOptions& options) {
  const auto moment = std::make_shared<Moment>();
  moment->scene = scene_at(scene, time);
  moment->renderer = make_renderer(moment->scene, options);
  return {moment, moment->renderer.get()};
}

}  // namespace

RenderersOverTime::RenderersOverTime(const Scene& scene, const RenderOptions& options)
    : scene_(&scene), options_(options) {
  options.validate();
  if (!moves(scene)) {
    still_ = scene.motion.animations.empty() ? make_renderer(scene, options)
                                             : renderer_at(scene, 0, options);
  }
}

std::shared_ptr<const Renderer> RenderersOverTime::at(double time) const {
  return still_ != nullptr ? still_ : renderer_at(*scene_, time, options_);
}

}  // namespace synth
