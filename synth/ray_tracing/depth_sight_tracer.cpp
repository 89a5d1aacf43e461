#include "synth/ray_tracing/depth_sight_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "synth/shading/glass.h"
#include "synth/shading/shading.h"
#include "synth/shading/surface.h"

namespace synth {
namespace {

constexpr int kMostClear = 16;           // clear surfaces on one line; a further one is opaque
constexpr float kSmooth = 0.1F;          // greatest roughness of a surface that shows an image
constexpr float kLeastShare = 0.5F;      // least part of the light that a clear surface sends on
constexpr float kGrazingCosine = 0.05F;  // at which the rounding of a position counts in full
constexpr double kDepthError = 1e-6;     // relative, of a depth in single precision

/// Returns what the mean of red, green and blue of a mirror reflects, by Schlick's approximation.
float mirror_share(const SurfacePoint& point, float cosine) {
  const float straight = point.metallic * point.base_color.mean();
  return straight + (1 - straight) * std::pow(1 - cosine, 5.0F);
}

/// Returns what passes one surface of glass; a thin wall has two boundaries, between which light
/// goes to and fro: (1 - F) / (1 + F).
float glass_share(const SurfacePoint& point, const Material& material, float cosine, float ratio) {
  const float mirrored = glass_reflectance(point, material, cosine, ratio);
  const float passed = material.layers.is_solid ? 1 - mirrored : (1 - mirrored) / (1 + mirrored);
  return point.transmission * passed * point.base_color.mean();
}

/// Returns how bright a surface is to a camera that lights it, as a share of a white diffuse wall
/// straight ahead.
float brightness(const SurfacePoint& point) {
  const float cosine = std::max(0.0F, point.normal.dot(point.to_viewer));
  return std::numbers::pi_v<float> * reflectance(point, point.to_viewer).mean() * cosine;
}

/// Returns the cosine of the incidence on the triangle.
float incidence_cosine(const SurfacePoint& point) {
  return std::clamp(point.face_normal.dot(point.to_viewer), 0.0F, 1.0F);
}

}  // namespace

FirstSurface clear_kind(const SurfacePoint& point) {
  if (point.roughness > kSmooth) {
    return FirstSurface::opaque;
  }
  if (point.transmission * (1 - point.metallic) >= kLeastShare) {
    return FirstSurface::glass;
  }
  return point.metallic * point.base_color.mean() >= kLeastShare ? FirstSurface::mirror
                                                                 : FirstSurface::opaque;
}

float share_sent_on(FirstSurface kind, const SurfacePoint& point, const Material& material,
                    float ratio) {
  switch (kind) {
    case FirstSurface::glass:
      return glass_share(point, material, incidence_cosine(point), ratio);
    case FirstSurface::mirror:
      return mirror_share(point, incidence_cosine(point));
    case FirstSurface::opaque:
      break;
  }
  return 0;
}

bool may_show_clear_surfaces(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
    const bool may_be_smooth =
        material.roughness <= kSmooth || material.metallic_roughness_texture.texture != kNone;
    return may_be_smooth &&
           (material.layers.transmission >= kLeastShare || material.metallic >= kLeastShare);
  });
}

/// A line of sight, made straight: behind a mirror it goes on from the mirror's image of the eye,
/// where it was refracted from a point against its new direction. Depths along it are of the
/// optical path.
struct DepthSightTracer::Line {
  cv::Point pixel;
  PlaneView eye;
  Eigen::Vector3d direction;  ///< world axes, m per m of depth; component 1 along eye.depth_axis
  double index = 1;           ///< of refraction of what the line is in
  /// From world axes as mirrors and refraction show them to world axes.
  Eigen::Matrix3d R_world_mirrored = Eigen::Matrix3d::Identity();
  float near = 0;       ///< m, depth of the last clear surface, with a margin
  float bent_at = 0;    ///< m, depth of the last surface that refracted the line; 0 before any
  float spread_to = 0;  ///< m, `spread` there
  float share = 1;      ///< of light, what clear surfaces send on, one way

  float length_per_depth() const { return static_cast<float>(direction.norm()); }

  /// Returns the length, m, by whose square the light of a lamp at the camera has fallen at a depth
  /// from `bent_at` on: the sum of lengths over indices of refraction, the reduced distance, which
  /// near the normals of refracting faces is how far off the lamp's image is.
  float spread(float depth) const {
    return spread_to + length_per_depth() * (depth - bent_at) / static_cast<float>(index);
  }
};

/// A surface on a line of sight.
struct DepthSightTracer::Met {
  FirstSurface kind = FirstSurface::opaque;
  DepthPlane plane;
  double depth = 0;  ///< m, along PlaneView::depth_axis
  SurfacePoint point;
  float returned = 0;  ///< light that returns, as in DepthSight
  float share = 0;     ///< of the light, what a clear surface sends on
  float margin = 0;    ///< m of depth, within which the surface may be met again
  float ratio = 1;     ///< index of refraction behind the surface over that before it, if it bends
};

DepthSightTracer::Met DepthSightTracer::meet(const Line& line, const HitPacket& packet,
                                             int lane) const {
  const int mesh = packet.mesh(lane);
  const int triangle = packet.triangle(lane);
  const float share = packet.share(lane);
  Met met{.plane = depth_plane(world_.meshes[static_cast<std::size_t>(mesh)], triangle, line.eye)};
  const float traced = packet.lanes.ray.tfar[lane];
  met.depth = met.plane.depth_along(line.direction).value_or(traced);
  const SurfaceTriangle surface(world_, mesh, triangle, share);
  met.point = surface_point(surface, {packet.weights(lane), line.direction.cast<float>(),
                                      view_.pixel_width() * traced, share});
  if (!met.plane.normal.isZero(0)) {  // a triangle without area has no plane to mirror in
    met.kind = clear_kind(met.point);
  }
  const Material& material = *surface.mesh->material;
  if (met.kind == FirstSurface::glass && bends(material)) {
    met.ratio = index_ratio(met.point, material);
  }
  met.share =
      share_sent_on(met.kind, met.point, material, met.ratio == 1 ? material.ior : met.ratio);
  const float shares = line.share / (static_cast<float>(line.index) * line.spread(traced));
  met.returned = shares * shares * brightness(met.point);
  met.margin =
      static_cast<float>(kDepthError * met.depth) +
      2 * met.point.rounding /
          (line.length_per_depth() * std::max(kGrazingCosine, incidence_cosine(met.point)));
  return met;
}

/// Returns whether glass of this material bends the line of sight: that of solids that pass light.
bool DepthSightTracer::bends(const Material& material) const {
  return view_.solids() == SolidGlass::refracted && material.layers.is_solid && material.ior != 0;
}

/// Leads a line to what a mirror shows.
void DepthSightTracer::reflect(const Met& met, Line& line) {
  const Eigen::Vector3d& n = met.plane.normal;
  const Eigen::Matrix3d mirror =
      Eigen::Matrix3d::Identity() - 2 / n.squaredNorm() * n * n.transpose();
  line.eye.eye += 2 * met.plane.offset / n.squaredNorm() * n;
  line.eye.depth_axis = mirror * line.eye.depth_axis;
  line.direction = mirror * line.direction;
  line.R_world_mirrored = line.R_world_mirrored * mirror;
}

/// Leads a line on in a unit direction, from where it meets the surface.
void DepthSightTracer::refract(const Met& met, const Eigen::Vector3f& onward, Line& line) {
  const Eigen::Vector3d before = line.direction;
  const Eigen::Vector3d place = line.eye.eye + met.depth * before;
  const auto depth = static_cast<float>(met.depth);
  line.spread_to = line.spread(depth);
  line.bent_at = depth;
  line.index *= met.ratio;
  line.direction = before.norm() / met.ratio * onward.cast<double>().normalized();
  line.eye.eye = place - met.depth * line.direction;
  line.eye.depth_axis = line.direction / line.direction.squaredNorm();
  line.R_world_mirrored =
      line.R_world_mirrored * Eigen::Quaterniond::FromTwoVectors(line.direction, before);
}

/// Leads a line on behind glass, or to what a mirror shows. Inside glass a surface is a mirror
/// beyond the critical angle.
void DepthSightTracer::go_on(const Met& met, Line& line) {
  line.near = static_cast<float>(met.depth) + met.margin;
  if (met.ratio != 1) {
    const std::optional<Eigen::Vector3f> onward =
        refracted(met.point.to_viewer, met.point.face_normal, met.ratio);
    if (onward) {
      line.share *= met.share;
      refract(met, *onward, line);
    } else {
      reflect(met, line);
    }
    return;
  }
  line.share *= met.share;
  if (met.kind == FirstSurface::mirror) {
    reflect(met, line);
  }
}

void DepthSightTracer::record(const Line& line, const Met& met, DepthSight& sight) const {
  const Eigen::Vector3d& n = met.plane.normal;
  const Eigen::Vector3d towards = n.dot(line.direction) > 0 ? Eigen::Vector3d(-n) : n;
  const Eigen::Vector3d normal = view_.R_world_camera(line.pixel.y).transpose() *
                                 (line.R_world_mirrored * towards).normalized();
  sight.beyond(line.pixel) = static_cast<float>(met.depth);
  sight.beyond_normal(line.pixel) = cv::Vec3d(normal.x(), normal.y(), normal.z());
  sight.beyond_returned(line.pixel) = met.returned;
}

/// Adds what the pixel of a line sees at its end. Radiance that leaves a solid falls with the
/// square of its index of refraction.
void DepthSightTracer::add_seen(const Line& line, const Met& met, SeenPoints& seen) {
  const double index2 = line.index * line.index;
  seen.lanes[static_cast<std::size_t>(seen.size++)] = {
      .pixel = line.pixel,
      .point = met.point,
      .distance = static_cast<float>(line.index * line.direction.norm() * met.depth),
      .spread = line.spread(static_cast<float>(met.depth)),
      .share = line.share / static_cast<float>(index2)};
}

void DepthSightTracer::add_multipath(const SeenPoints& seen, DepthSight& sight) const {
  const MultipathTracer::Phasors phasors = multipath_.trace(seen);
  for (std::size_t i = 0; i < static_cast<std::size_t>(seen.size); ++i) {
    sight.multipath(seen.lanes[i].pixel) = {static_cast<float>(phasors[i].real()),
                                            static_cast<float>(phasors[i].imag())};
  }
}

CameraRay DepthSightTracer::ray_along(const Line& line) const {
  return {(line.eye.eye - world_.origin).cast<float>(), line.direction.cast<float>(), line.near,
          std::numeric_limits<float>::infinity(), line.eye.share};
}

void DepthSightTracer::follow(const cv::Point* pixels, const HitPacket& first,
                              DepthSight& sight) const {
  HitPacket packet = first;
  SeenPoints seen;
  std::array<Line, kPacketSize> lines;
  for (int lane = 0; lane < packet.size; ++lane) {
    lines[static_cast<std::size_t>(lane)] = {pixels[lane], view_.eye(pixels[lane]),
                                             view_.direction(pixels[lane])};
  }
  for (int met_before = 0; packet.size > 0; ++met_before) {
    HitPacket onward;
    for (int lane = 0; lane < packet.size; ++lane) {
      if (!packet.has_hit(lane)) {
        continue;
      }
      Line line = lines[static_cast<std::size_t>(lane)];
      const Met met = meet(line, packet, lane);
      if (met_before == 0) {
        sight.first(line.pixel) = static_cast<std::uint8_t>(met.kind);
        sight.returned(line.pixel) = met.returned;
      }
      if (met.kind == FirstSurface::opaque || met_before == kMostClear) {
        record(line, met, sight);
        add_seen(line, met, seen);
      } else {
        go_on(met, line);
        lines[static_cast<std::size_t>(onward.size)] = line;
        add_ray(onward, ray_along(line));
      }
    }
    if (onward.size > 0) {
      embree_.intersect(onward, Sight::solid);
    }
    packet = onward;
  }
  if (!sight.multipath.empty()) {
    add_multipath(seen, sight);
  }
}

}  // namespace synth
