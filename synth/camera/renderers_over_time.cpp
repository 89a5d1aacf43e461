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

}  // namespace

RenderersOverTime::RenderersOverTime(const Scene& scene, const RenderOptions& options)
    : scene_(&scene), options_(options) {
  options.validate();
  if (!moves(scene)) {
    still_ = make_renderer(scene, options);
  }
}

std::shared_ptr<const Renderer> RenderersOverTime::at(double time) const {
  if (still_ != nullptr) {
    return still_;
  }
  const auto moment = std::make_shared<Moment>();
  moment->scene = scene_at(*scene_, time);
  moment->renderer = make_renderer(moment->scene, options_);
  return {moment, moment->renderer.get()};
}

}  // namespace synth
