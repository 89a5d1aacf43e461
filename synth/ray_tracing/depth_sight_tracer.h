#pragma once

#include <opencv2/core.hpp>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/ray_tracing/multipath_tracer.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "synth/scene/world_geometry.h"

namespace synth {

/// Returns whether a scene may show glass or mirrors, as FirstSurface says; a texture may make any
/// metal smooth, or glass.
bool may_show_clear_surfaces(const Scene& scene);

/// Returns what a depth camera takes a point of a surface for.
FirstSurface clear_kind(const SurfacePoint& point);

/// Returns the part of the light, 0 to 1, that a clear surface of this kind sends on, through it or
/// mirrored, of what comes from the point's viewer; 0 if it is opaque. `ratio` is the index of
/// refraction behind glass over that before it.
float share_sent_on(FirstSurface kind, const SurfacePoint& point, const Material& material,
                    float ratio);

/// Follows the lines of sight of a depth camera through glass and by mirrors. Refers to its
/// arguments, which must outlive it.
class DepthSightTracer {
 public:
  DepthSightTracer(const WorldGeometry& world, const EmbreeScene& embree, const View& view)
      : world_(world), embree_(embree), view_(view), multipath_(world, embree, view) {}

  /// Fills the sight of a packet's pixels, whose rays have met the scene.
  void follow(const cv::Point* pixels, const HitPacket& first, DepthSight& sight) const;

 private:
  struct Line;
  struct Met;

  Met meet(const Line& line, const HitPacket& packet, int lane) const;
  bool bends(const Material& material) const;
  static void reflect(const Met& met, Line& line);
  static void refract(const Met& met, const Eigen::Vector3f& onward, Line& line);
  static void go_on(const Met& met, Line& line);
  CameraRay ray_along(const Line& line) const;
  void record(const Line& line, const Met& met, DepthSight& sight) const;
  static void add_seen(const Line& line, const Met& met, SeenPoints& seen);
  void add_multipath(const SeenPoints& seen, DepthSight& sight) const;

  const WorldGeometry& world_;
  const EmbreeScene& embree_;
  const View& view_;
  MultipathTracer multipath_;
};

}  // namespace synth
