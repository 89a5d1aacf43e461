#pragma once

#include <memory>
#include <utility>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"

namespace synth {

/// Provides renderers of an animated scene as it is at chosen times. The scene must outlive it.
class RenderersOverTime {
 public:
  RenderersOverTime(const Scene& scene, const RenderOptions& options);

  /// Uses one renderer for all times.
  explicit RenderersOverTime(std::shared_ptr<const Renderer> still) : still_(std::move(still)) {}

  /// Returns a renderer of the scene at a time, s; builds a new one if anything in the scene moves.
  std::shared_ptr<const Renderer> at(double time) const;

 private:
  const Scene* scene_ = nullptr;
  RenderOptions options_;
  std::shared_ptr<const Renderer> still_;  ///< null if anything in the scene moves
};

}  // namespace synth
