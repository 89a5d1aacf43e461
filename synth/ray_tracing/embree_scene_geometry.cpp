#include "synth/ray_tracing/embree_scene_geometry.h"

#include <algorithm>
#include <vector>

#include "synth/shading/glass.h"
#include "synth/shading/surface.h"

namespace synth {
namespace {

EmbreeQuery& query_of(const RTCFilterFunctionNArguments* arguments) {
  return *reinterpret_cast<EmbreeQuery*>(arguments->context);
}

/// Returns the hit of one lane of the rays that a filter function receives.
SurfaceHit hit_of(const RTCFilterFunctionNArguments* arguments, unsigned lane) {
  RTCHitN* const hits = arguments->hit;
  const unsigned count = arguments->N;
  const float u = RTCHitN_u(hits, count, lane);
  const float v = RTCHitN_v(hits, count, lane);
  return {.mesh = mesh_of(RTCHitN_instID(hits, count, lane, 0), RTCHitN_geomID(hits, count, lane)),
          .triangle = static_cast<int>(RTCHitN_primID(hits, count, lane)),
          .weights = {1 - u - v, u, v}};
}

/// Filter function that records the last triangle that a ray hit as the query's occluder.
void note_blocker(const RTCFilterFunctionNArguments* arguments) {
  ShadowHit* const occluder = query_of(arguments).occluder;
  const unsigned count = arguments->N;
  for (unsigned i = 0; occluder != nullptr && i < count; ++i) {
    if (arguments->valid[i] == -1) {
      const SurfaceHit hit = hit_of(arguments, i);
      *occluder = {hit.mesh, hit.triangle};
    }
  }
}

/// Filter function that lets rays pass where alpha is below what stops them.
void drop_invisible(const RTCFilterFunctionNArguments* arguments) {
  const auto& world = *static_cast<const WorldGeometry*>(arguments->geometryUserPtr);
  const bool sees_layers = query_of(arguments).sight == Sight::layers;
  const unsigned count = arguments->N;
  for (unsigned i = 0; i < count; ++i) {
    if (arguments->valid[i] != -1) {
      continue;
    }
    const SurfaceHit hit = hit_of(arguments, i);
    const Material& material = *world.meshes[static_cast<std::size_t>(hit.mesh)].material;
    const bool is_layer = material.alpha_mode == AlphaMode::blend && sees_layers;
    if (!is_layer && surface_alpha(world, hit) < solid_from(material)) {
      arguments->valid[i] = 0;
    }
  }
}

/// Filter function of clear walls for shadow rays: drops their hits where they cast no shadow, and
/// is the filter of other surfaces where they do.
template <RTCFilterFunctionN kOtherwise>
void drop_clear_wall(const RTCFilterFunctionNArguments* arguments) {
  if (query_of(arguments).casters == ShadowCasters::all) {
    kOtherwise(arguments);
  } else {
    std::fill_n(arguments->valid, arguments->N, 0);
  }
}

/// Sets the vertices of a time step; the last position is only padding for Embree's reads.
void set_vertices(RTCGeometry geometry, const std::vector<Eigen::Vector3f>& positions,
                  unsigned time_step) {
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, time_step, RTC_FORMAT_FLOAT3,
                             positions.data(), 0, sizeof(Eigen::Vector3f), positions.size() - 1);
}

/// Sets the vertices at each moment; Embree spreads moments evenly over the rays' time, 0 to 1.
void set_vertices(RTCGeometry geometry, const FlatMesh& world) {
  if (world.moments.empty()) {
    set_vertices(geometry, world.positions, 0);
    return;
  }
  const auto moments = static_cast<unsigned>(world.moments.size());
  rtcSetGeometryTimeStepCount(geometry, moments);
  for (unsigned i = 0; i < moments; ++i) {
    set_vertices(geometry, world.moments[i].positions, i);
  }
}

void set_triangles(RTCGeometry geometry, const Mesh& mesh) {
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                             mesh.triangles.size());
}

void set_filters(RTCGeometry geometry, const WorldGeometry& scene, const Mesh& mesh) {
  const Material& material = material_of(*scene.scene, mesh);
  rtcSetGeometryUserData(geometry,
                         const_cast<WorldGeometry*>(&scene));  // Embree's callbacks only read it
  const bool is_wall = is_clear_wall(material);
  if (material.alpha_mode != AlphaMode::opaque) {
    rtcSetGeometryIntersectFilterFunction(geometry, drop_invisible);
    rtcSetGeometryOccludedFilterFunction(
        geometry, is_wall ? drop_clear_wall<drop_invisible> : drop_invisible);
  } else {
    rtcSetGeometryOccludedFilterFunction(geometry,
                                         is_wall ? drop_clear_wall<note_blocker> : note_blocker);
  }
}

EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene, const Mesh& mesh) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  set_triangles(geometry.get(), mesh);
  set_filters(geometry.get(), scene, mesh);
  return geometry;
}

void set_transform(RTCGeometry geometry, const WorldGeometry& scene, const FlatMesh& mesh,
                   unsigned time_step) {
  const Eigen::Matrix<float, 3, 4> transform = T_flat_shared(scene, mesh).affine().cast<float>();
  rtcSetGeometryTransform(geometry, time_step, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, transform.data());
}

}  // namespace

EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene,
                            const SharedMesh& shared) {
  EmbreeGeometry geometry = triangles_of(device, scene, *shared.mesh);
  set_vertices(geometry.get(), shared.positions, 0);
  return geometry;
}

EmbreeGeometry triangles_of(RTCDevice device, const WorldGeometry& scene, const FlatMesh& mesh) {
  EmbreeGeometry geometry = triangles_of(device, scene, *mesh.mesh);
  set_vertices(geometry.get(), mesh);
  return geometry;
}

EmbreeGeometry instance_of(RTCDevice device, RTCScene shared, const WorldGeometry& scene,
                           const FlatMesh& mesh) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(geometry.get(), shared);
  const auto moments = static_cast<unsigned>(mesh.moments.size());
  if (moments == 0) {
    set_transform(geometry.get(), scene, mesh, 0);
  } else {
    rtcSetGeometryTimeStepCount(geometry.get(), moments);
  }
  for (unsigned i = 0; i < moments; ++i) {
    set_transform(geometry.get(), scene, mesh.moments[i], i);
  }
  return geometry;
}

}  // namespace synth
