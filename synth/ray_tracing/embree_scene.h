#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/ray_tracing/embree_queries.h"
#include "synth/rendering/capture.h"
#include "synth/scene/world_geometry.h"
#include "synth/shading/lanes.h"
#include "synth/shading/shading.h"
#include "synth/shading/shading_lanes.h"
#include "vo/core/random_field.h"
#include "vo/geometry/camera_model.h"

namespace synth {

/// Returns the index into WorldGeometry::meshes of a hit's Embree instance and geometry IDs.
inline int mesh_of(unsigned instance, unsigned geometry) {
  return static_cast<int>(instance == RTC_INVALID_GEOMETRY_ID ? geometry : instance);
}

/// Rays that are traced together, with their hits, in the first `size` lanes.
struct HitPacket {
  RTCRayHit16 lanes;
  int size = 0;
  Coherence coherence = Coherence::coherent;

  bool has_hit(int lane) const { return lanes.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID; }
  int mesh(int lane) const { return mesh_of(lanes.hit.instID[0][lane], lanes.hit.geomID[lane]); }
  int triangle(int lane) const { return static_cast<int>(lanes.hit.primID[lane]); }
  Eigen::Vector3f weights(int lane) const {  ///< barycentric, of the triangle's vertices
    const float u = lanes.hit.u[lane];
    const float v = lanes.hit.v[lane];
    return {1 - u - v, u, v};
  }
  Eigen::Vector3f direction(int lane) const {
    return {lanes.ray.dir_x[lane], lanes.ray.dir_y[lane], lanes.ray.dir_z[lane]};
  }
  float share(int lane) const { return lanes.ray.time[lane]; }  ///< from WorldGeometry::share_at
};

/// Shadow rays towards one light. Lanes that are not active hold numbers but no ray.
struct ShadowPacket {
  RTCRay16 lanes;
  alignas(64) LaneMask active;
  Coherence coherence = Coherence::coherent;

  bool has_rays() const { return std::find(active.begin(), active.end(), -1) != active.end(); }
};

/// The triangle that stopped a shadow ray.
struct ShadowHit {
  int mesh = kNone;      ///< index into WorldGeometry::meshes
  int triangle = kNone;  ///< index into Mesh::triangles
};

/// The surfaces that stop a ray. `solid`, for depth, shadows and labels: those with alpha of at
/// least a mask's cutoff, or 0.5 if blended. `layers`, for colour: also all other blended surfaces.
enum class Sight { solid, layers };

/// The surfaces that cast shadows: all that are solid, or those but clear walls (`is_clear_wall`).
enum class ShadowCasters { all, all_but_clear_walls };

/// Embree's bounding volume hierarchy of a world-space geometry, which must outlive it.
class EmbreeScene {
 public:
  explicit EmbreeScene(const WorldGeometry& world);

  /// Finds the nearest hit of each ray, faster if neighbours in the list are coherent.
  void intersect(std::vector<RTCRayHit>& rays) const;

  /// Finds whether each ray hits anything, for is_occluded() to tell.
  void occlude(std::vector<RTCRay>& rays) const;

  void intersect(HitPacket& packet, Sight sight) const;

  /// Deactivates the rays that hit something. `occluder` becomes the last opaque triangle that
  /// stopped a ray, if one did.
  void occlude(ShadowPacket& packet, ShadowHit& occluder,
               ShadowCasters casters = ShadowCasters::all) const;

  RTCScene hierarchy() const { return hierarchy_.get(); }

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };

  using Hierarchy = std::unique_ptr<RTCSceneTy, Release>;

  Hierarchy new_hierarchy() const;

  Coherence shadow_coherence_;
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::vector<Hierarchy> shared_;  ///< one for each of WorldGeometry::shared_meshes
  Hierarchy hierarchy_;
};

bool has_hit(const RTCRayHit& ray);
bool is_occluded(const RTCRay& ray);  ///< after EmbreeScene::occlude
SurfaceHit surface_hit(const RTCHit& hit);

/// A ray from `near` to `reach`, both in lengths of its direction.
struct CameraRay {
  Eigen::Vector3f from;  ///< m, in the world-space geometry's coordinates
  Eigen::Vector3f direction;
  float near = 0;
  float reach = std::numeric_limits<float>::infinity();
  float share = 0;  ///< WorldGeometry::share_at of the time at which it sees the scene
};

/// Returns a ray that leaves a surface in a unit direction, on either side of it.
inline CameraRay ray_from(const SurfacePoint& point, const Eigen::Vector3f& direction) {
  const float side = point.face_normal.dot(direction) < 0 ? -1.0F : 1.0F;
  CameraRay ray{point.position + side * point.rounding * point.face_normal, direction};
  ray.share = point.share;
  return ray;
}

void add_ray(HitPacket& packet, const CameraRay& ray);

/// Sets a camera ray from a point, m, in the world-space geometry's coordinates, along a direction
/// whose multiples are depths.
void aim_along(RTCRayHit& ray, const Eigen::Vector3f& from, const Eigen::Vector3f& direction);

/// Returns the reach of a shadow ray in lengths of DirectLight::to_light: 1 or infinity.
float shadow_reach(const PlacedLight& light);

/// Sets a shadow ray from a surface point to `light`, which lights the point as `direct` says.
void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const PlacedLight& light);

/// Returns shadow rays from all points, for aim_at_light() to direct to one light after another.
ShadowPacket shadow_rays(const LitLanes& lit);

/// Directs shadow rays to a light and activates those from the points that the light may reach.
/// `reach` is in lengths of LightLanes::to_light.
void aim_at_light(ShadowPacket& packet, const LightLanes& direct, float reach);

/// One of the equal squares of a pixel in which its colour is sampled.
struct PixelCell {
  Eigen::Vector2d offset;  ///< px, from the pixel's centre to the cell's
  double instant = 0;      ///< fraction of the exposure after the pixel's first instant, modulo 1
};

/// Returns a pixel's cells row by row. Their instants are spread evenly over the exposure, along
/// rows and columns too: they differ by the steps of Roberts' R2 sequence.
std::vector<PixelCell> grid_of_cells(int per_edge);

/// The camera rays of a capture of a world-space geometry. Both must outlive it.
class View {
 public:
  View(const WorldGeometry& world, const Capture& capture);

  const vo::CameraModel& camera() const { return capture_.camera; }
  Eigen::Matrix3d R_world_camera(int v) const { return poses_.of_row(v).R_world_camera; }
  const Eigen::Vector3d& position(int v) const { return poses_.of_row(v).position; }  ///< m, world
  std::uint64_t seed() const { return capture_.seed; }
  SolidGlass solids() const { return capture_.solids; }
  const MultipathOptions& multipath() const { return capture_.multipath; }
  float pixel_width() const { return pixel_width_; }  ///< m, CameraModel::pixel_width

  /// Returns how an infrared camera sees; null for one that sees colours.
  const InfraredBand* infrared() const { return capture_.infrared ? &*capture_.infrared : nullptr; }

  /// Returns whether all pixels see a triangle's plane from one PlaneView.
  bool has_one_eye() const { return is_at_rest() && camera().has_optical_axis(); }

  /// Aims a ray through a pixel's centre in the middle of its row's exposure.
  void aim_at_centre(const cv::Point& pixel, RTCRayHit& ray) const;
  void add_ray_at_centre(const cv::Point& pixel, HitPacket& packet) const;

  /// Adds a ray through the centre of one of the pixel's cells at the cell's own instant.
  void add_ray_at_cell(const cv::Point& pixel, const PixelCell& cell, HitPacket& packet) const;

  /// Returns the camera's pose at that instant.
  CameraPose pose_at_cell(const cv::Point& pixel, const PixelCell& cell) const;

  /// Returns whether pixels see through cones that are not round, which have `pixel_sides`.
  bool has_pixel_sides() const { return camera().pixel_sides({0, 0}).has_value(); }

  /// Returns the sides of the cone through which a pixel sees.
  RaySides pixel_sides(const cv::Point& pixel) const;

  /// Returns the depth, m, at which the ray through the pixel's centre meets the plane of the
  /// triangle that `ray` hit; the single-precision depth of `ray` if depth_of() gives none.
  float exact_depth(const cv::Point& pixel, const RTCRayHit& ray) const;
  std::optional<double> depth_of(const DepthPlane& plane, const cv::Point& pixel) const;

  /// Returns from where a pixel sees in the middle of its row's exposure, and along which axis its
  /// depth counts: the optical one or, of a camera without, its own ray.
  PlaneView eye(const cv::Point& pixel) const;

  /// Returns the CameraModel::ray of a pixel's centre, world axes.
  Eigen::Vector3d direction(const cv::Point& pixel) const {
    return direction(poses_.of_row(pixel.y), {pixel.x, pixel.y});
  }

  /// Returns the plane of a triangle as a pixel sees it in the middle of its row's exposure.
  DepthPlane plane_of(int mesh, int triangle, const cv::Point& pixel) const;

  /// Returns the unit normal, in camera axes and towards the camera, of the triangle that the ray
  /// through the pixel's centre hit.
  cv::Vec3f normal(const cv::Point& pixel, const HitPacket& packet, int lane) const;

 private:
  /// A generator of a pinhole camera's rays at one instant, for a lens that does not distort.
  struct RayGenerator {
    Eigen::Matrix3d direction_from_pixel;  ///< R_world_camera K^-1
    Eigen::Vector3f start;                 ///< m, in the world-space geometry's coordinates
    float share;                           ///< value of WorldGeometry::share_at
  };

  /// Returns whether all rows are exposed at once, so that they share one camera pose and time.
  bool is_at_rest() const { return capture_.shutter.readout_time == 0; }

  float share_at(double time) const { return world_.share_at(capture_.scene_time + time); }
  float share_of_row(int v) const {
    return share_at(capture_.shutter.row_time(v, capture_.camera.height()));
  }
  CameraRay ray_from(const CameraPose& camera_pose, const Eigen::Vector2d& pixel,
                     float share) const;
  CameraRay ray_from_row(int v, const Eigen::Vector2d& pixel) const;
  double time_of_cell(const cv::Point& pixel, const PixelCell& cell) const;
  Eigen::Vector3d direction(const CameraPose& camera_pose, const Eigen::Vector2d& pixel) const;

  const WorldGeometry& world_;
  const Capture& capture_;
  CapturePoses poses_;
  vo::RandomField instants_;  ///< each pixel's first instant, fraction of the exposure
  float pixel_width_;
  std::vector<RayGenerator> ray_generators_;  ///< per row, one for all, or none for other cameras
};

}  // namespace synth
