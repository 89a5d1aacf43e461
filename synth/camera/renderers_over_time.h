#pragma once

#include <memory>
#include <utility>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"

namespace synth {

/// Renderers of a scene as it is at times of its animations. What they are made from must outlive
/// them.
class RenderersOverTime {
 public:
  RenderersOverTime(const Scene& scene, const RenderOptions& options);

  /// One renderer for all times.
  explicit RenderersOverTime(std::shared_ptr<const Renderer> still) : still_(std::move(still)) {}

  /// Time in s. Builds one, but where nothing moves.
  std::shared_ptr<const Renderer> at(double time) const;

 private:
  const Scene* scene_ = nullptr;
  RenderOptions options_;
  std::shared_ptr<const Renderer> still_;  ///< none where something moves
};

}  // namespace synth
