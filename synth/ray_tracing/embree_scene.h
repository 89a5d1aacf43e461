#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <embree3/rtcore.h>
#include <opencv2/core.hpp>

#include "synth/rendering/capture.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/lanes.h"
#include "synth/shading/shading.h"
#include "synth/shading/shading_lanes.h"
#include "vo/core/random_field.h"
#include "vo/geometry/camera.h"

namespace synth {

/// Of WorldGeometry::meshes, by Embree's numbers of a hit.
inline int mesh_of(unsigned instance, unsigned geometry) {
  return static_cast<int>(instance == RTC_INVALID_GEOMETRY_ID ? geometry : instance);
}

/// Rays that go nearly the same way and are traced together: the first `size` lanes.
struct HitPacket {
  RTCRayHit16 lanes;
  int size = 0;

  bool has_hit(int lane) const { return lanes.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID; }
  int mesh(int lane) const { return mesh_of(lanes.hit.instID[0][lane], lanes.hit.geomID[lane]); }
  int triangle(int lane) const { return static_cast<int>(lanes.hit.primID[lane]); }
  Eigen::Vector3f weights(int lane) const {  ///< of the triangle's vertices
    const float u = lanes.hit.u[lane];
    const float v = lanes.hit.v[lane];
    return {1 - u - v, u, v};
  }
  Eigen::Vector3f direction(int lane) const {
    return {lanes.ray.dir_x[lane], lanes.ray.dir_y[lane], lanes.ray.dir_z[lane]};
  }
  float share(int lane) const { return lanes.ray.time[lane]; }  ///< WorldGeometry::share_at
};

/// Rays of a packet towards one light. Lanes that are not active hold numbers but no ray.
struct ShadowPacket {
  RTCRay16 lanes;
  alignas(64) LaneMask active;

  bool has_rays() const { return std::find(active.begin(), active.end(), -1) != active.end(); }
};

/// The triangle that stopped a shadow ray.
struct ShadowHit {
  int mesh = kNone;      ///< of WorldGeometry::meshes
  int triangle = kNone;  ///< of that mesh
};

/// What a ray stops at: what depth, shadows and labels see, where alpha is at or above a mask's
/// cutoff or half of a blended surface; or every layer that colour is blended of.
enum class Sight { solid, layers };

/// Finds what rays hit. The world-space geometry must outlive it.
class EmbreeScene {
 public:
  explicit EmbreeScene(const WorldGeometry& world);

  /// The nearest hit of each ray. Faster when neighbours in the list go nearly the same way.
  void intersect(std::vector<RTCRayHit>& rays) const;

  /// Whether each ray hits anything: see `is_occluded`.
  void occlude(std::vector<RTCRay>& rays) const;

  void intersect(HitPacket& packet, Sight sight) const;

  /// Leaves those rays active that meet nothing. `occluder` becomes the last opaque triangle that
  /// stopped a ray, if one did.
  void occlude(ShadowPacket& packet, ShadowHit& occluder) const;

  RTCScene hierarchy() const { return hierarchy_.get(); }

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  using Hierarchy = std::unique_ptr<RTCSceneTy, Release>;

  Hierarchy new_hierarchy() const;

  RTCIntersectContextFlags shadow_coherence_;
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::vector<Hierarchy> shared_;  ///< of WorldGeometry::shared_meshes
  Hierarchy hierarchy_;
};

bool has_hit(const RTCRayHit& ray);
bool is_occluded(const RTCRay& ray);  ///< after `occlude`
SurfaceHit surface_hit(const RTCHit& hit);

/// Where a ray goes; `near` and `reach` are in lengths of the direction.
struct CameraRay {
  Eigen::Vector3f from;  ///< m, in the world-space geometry's coordinates
  Eigen::Vector3f direction;
  float near = 0;
  float reach = std::numeric_limits<float>::infinity();
  float share = 0;  ///< WorldGeometry::share_at, of when it sees the scene
};

void add_ray(HitPacket& packet, const CameraRay& ray);

/// A ray from a point of the world-space geometry along a direction that is 1 along the optical
/// axis.
void aim_along(RTCRayHit& ray, const Eigen::Vector3f& from, const Eigen::Vector3f& direction);

/// How far from a surface things cast shadows on it, in lengths of DirectLight::to_light.
float shadow_reach(const PlacedLight& light);

/// A ray from a surface point to the light that `direct` is about.
void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const PlacedLight& light);

/// Rays from all points; which way they go, `aim_at_light` says for one light after another.
ShadowPacket shadow_rays(const LitLanes& lit);

/// Active are the rays from the points that the light may reach.
void aim_at_light(ShadowPacket& packet, const LightLanes& direct, const PlacedLight& light);

/// One of the equal squares that a pixel's colour is sampled in.
struct PixelCell {
  Eigen::Vector2d offset;  ///< px, of its centre from the pixel's
  double instant = 0;      ///< share of the exposure after the pixel's first; counts round
};

/// Row by row. The instants are spread evenly over the exposure, along rows and columns too: their
/// differences are the terms of Roberts' R2 sequence.
std::vector<PixelCell> grid_of_cells(int per_edge);

/// A capture of a world-space geometry. Both must outlive it.
class View {
 public:
  View(const WorldGeometry& world, const Capture& capture);

  const vo::PinholeCamera& camera() const { return capture_.camera; }
  Eigen::Matrix3d R_world_camera(int v) const { return poses_.of_row(v).R_world_camera; }
  std::uint64_t seed() const { return capture_.seed; }
  float pixel_width() const { return pixel_width_; }  ///< m at 1 m

  /// Whether all rows are seen from one place, at one time.
  bool is_at_rest() const { return capture_.shutter.readout_time == 0; }

  /// Through a pixel's centre in the middle of its exposure.
  void aim_at_centre(const cv::Point& pixel, RTCRayHit& ray) const;
  void add_ray_at_centre(const cv::Point& pixel, HitPacket& packet) const;

  /// Through one of the pixel's cells at the cell's own instant.
  void add_ray_at_cell(const cv::Point& pixel, const PixelCell& cell, HitPacket& packet) const;

  /// Depth, m, at which the ray through the pixel's centre meets the plane of the triangle that
  /// `ray` hit; the ray's own where that makes no sense.
  float exact_depth(const cv::Point& pixel, const RTCRayHit& ray) const;
  std::optional<double> depth_of(const DepthPlane& plane, const cv::Point& pixel) const;

  /// The plane of a triangle as a row's camera sees it.
  DepthPlane plane_of(int mesh, int triangle, int v) const;

  /// Unit, camera's axes, of the triangle that the ray through the pixel's centre hit, towards the
  /// camera.
  cv::Vec3f normal(const cv::Point& pixel, const HitPacket& packet, int lane) const;

 private:
  /// A camera's rays, if its lens is perfect.
  struct RayGenerator {
    Eigen::Matrix3d direction_from_pixel;  ///< R_world_camera K^-1
    Eigen::Vector3f start;                 ///< m, in the world-space geometry's coordinates
    float share;                           ///< WorldGeometry::share_at
  };

  float share_at(double time) const { return world_.share_at(capture_.scene_time + time); }
  float share_of_row(int v) const {
    return share_at(capture_.shutter.row_time(v, capture_.camera.height));
  }
  CameraRay ray_from(const CameraPose& camera_pose, const Eigen::Vector2d& pixel,
                     float share) const;
  CameraRay ray_from_row(int v, const Eigen::Vector2d& pixel) const;
  Eigen::Vector3d direction(const CameraPose& camera_pose, const Eigen::Vector2d& pixel) const;

  const WorldGeometry& world_;
  const Capture& capture_;
  CapturePoses poses_;
  vo::RandomField instants_;  ///< where each pixel's instants start, share of the exposure
  float pixel_width_;
  std::vector<RayGenerator>
      ray_generators_;  ///< of each row, or one for all; none of a lens that distorts
};

}  // namespace synth
