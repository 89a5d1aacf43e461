#pragma once

#include <opencv2/core.hpp>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"

namespace synth {

/// Returns whether a scene may show glass or mirrors, as FirstSurface says; a texture may make any
/// metal smooth, or glass.
bool may_show_clear_surfaces(const Scene& scene);

/// Follows the lines of sight of a depth camera through glass and by mirrors. Refers to its
/// arguments, which must outlive it.
class DepthSightTracer {
 public:
  DepthSightTracer(const WorldGeometry& world, const EmbreeScene& embree, const View& view)
      : world_(world), embree_(embree), view_(view) {}

  /// Fills the sight of a packet's pixels, whose rays have met the scene.
  void follow(const cv::Point* pixels, const HitPacket& first, DepthSight& sight) const;

 private:
  struct Line;
  struct Met;

  Met meet(const Line& line, const HitPacket& packet, int lane) const;
  static void go_on(const Met& met, Line& line);
  CameraRay ray_along(const Line& line) const;
  void record(const Line& line, const Met& met, DepthSight& sight) const;

  const WorldGeometry& world_;
  const EmbreeScene& embree_;
  const View& view_;
};

}  // namespace synth
