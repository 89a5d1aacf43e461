#pragma once

#include <memory>

#include "synth/ray_tracing/embree_queries.h"
#include "synth/ray_tracing/embree_scene.h"
#include "synth/scene/world_geometry.h"

namespace synth {

/// An intersection query, which Embree passes to the filter functions. Embree's part is first.
struct EmbreeQuery {
  EmbreeContext context = embree_context();
  Sight sight = Sight::solid;
  ShadowCasters casters = ShadowCasters::all;
  ShadowHit* occluder = nullptr;  ///< receives the triangle that cast a shadow, if not null
};

struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeGeometry = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

/// Returns the triangles of a mesh as an Embree geometry that refers to the mesh's vertices. Rays
/// pass where alpha is below what stops them; queries must be of type EmbreeQuery.
EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene, const SharedMesh& shared);
EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene, const FlatMesh& mesh);

/// Returns an instance of a shared mesh as an Embree geometry. Between moments Embree interpolates
/// the transforms linearly, so that vertices move straight.
EmbreeGeometry instance_of(RTCDevice device, RTCScene shared, const WorldGeometry& scene,
                           const FlatMesh& mesh);

}  // namespace synth
