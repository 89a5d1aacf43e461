#pragma once

#include <memory>

#include <embree3/rtcore.h>

#include "synth/ray_tracing/embree_scene.h"
#include "synth/scene/world_geometry.h"

namespace synth {

/// What a query is about: Embree hands it on to the filters. Its own part comes first.
struct EmbreeQuery {
  RTCIntersectContext context;
  Sight sight = Sight::solid;
  ShadowHit* occluder = nullptr;  ///< where to note what cast a shadow
};

struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeGeometry = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

/// The triangles of a mesh, whose vertices they refer to. Rays pass where the alpha says that
/// nothing is; queries are of type EmbreeQuery.
EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene, const SharedMesh& shared);
EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene, const FlatMesh& mesh);

/// A shared mesh where an instance stands. Between moments Embree blends the matrices: vertices go
/// straight.
EmbreeGeometry instance_of(RTCDevice device, RTCScene shared, const WorldGeometry& scene,
                           const FlatMesh& mesh);

}  // namespace synth
