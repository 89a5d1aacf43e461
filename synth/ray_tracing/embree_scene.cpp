#include "synth/ray_tracing/embree_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "synth/ray_tracing/embree_scene_geometry.h"
#include "vo/core/error.h"

namespace synth {
namespace {

constexpr std::uint64_t kInstants = 0x1257;  // purpose of the instants' random numbers
constexpr float kNear = 0.01F;               // m of depth
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void keep_first_error(void* message, RTCError /*code*/, const char* text) {
  auto& first = *static_cast<std::string*>(message);
  if (first.empty()) {
    first = text;
  }
}

void attach(RTCScene hierarchy, RTCGeometry geometry, unsigned index) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(hierarchy, geometry, index);
}

void set_ray(RTCRay& embree_ray, const CameraRay& ray) {
  embree_ray.org_x = ray.from.x();
  embree_ray.org_y = ray.from.y();
  embree_ray.org_z = ray.from.z();
  embree_ray.dir_x = ray.direction.x();
  embree_ray.dir_y = ray.direction.y();
  embree_ray.dir_z = ray.direction.z();
  embree_ray.tnear = ray.near;
  embree_ray.tfar = ray.reach;
  embree_ray.time = ray.share;
  embree_ray.mask = std::numeric_limits<unsigned>::max();
}

void set_lane(RTCRay16& rays, int lane, const CameraRay& ray) {
  rays.org_x[lane] = ray.from.x();
  rays.org_y[lane] = ray.from.y();
  rays.org_z[lane] = ray.from.z();
  rays.dir_x[lane] = ray.direction.x();
  rays.dir_y[lane] = ray.direction.y();
  rays.dir_z[lane] = ray.direction.z();
  rays.tnear[lane] = ray.near;
  rays.tfar[lane] = ray.reach;
  rays.time[lane] = ray.share;
  rays.mask[lane] = std::numeric_limits<unsigned>::max();
}

struct alignas(64) FirstLanes {
  explicit FirstLanes(int size) {
    std::fill_n(mask.begin(), size, -1);
    std::fill(mask.begin() + size, mask.end(), 0);
  }
  LaneMask mask;
};

/// Puts a ray that ends before it begins, from the lane's own origin, into a lane that is not
/// traced. Embree 3.13 ignores the mask on processors without AVX-512: it traces all lanes and
/// aborts where one holds no numbers.
void retire_lane(RTCRay16& rays, int lane) {
  rays.dir_x[lane] = 0;
  rays.dir_y[lane] = 0;
  rays.dir_z[lane] = 1;
  rays.tfar[lane] = -kInfinity;
}

/// Returns the coherence flag of shadow rays: Embree 3.13 can hang in those through instances if
/// they are flagged as coherent.
Coherence shadow_coherence(const WorldGeometry& world) {
  return world.shared_meshes.empty() ? Coherence::coherent : Coherence::incoherent;
}

/// Returns a normal of the triangle that was hit, world axes, of any length and side. It is
/// computed for a shared mesh, whose normals Embree gives in the mesh's frame.
Eigen::Vector3f across_triangle(const WorldGeometry& world, const HitPacket& packet, int lane) {
  const FlatMesh& mesh = world.meshes[static_cast<std::size_t>(packet.mesh(lane))];
  if (mesh.shared == kNone) {
    const RTCHit16& hit = packet.lanes.hit;
    return {hit.Ng_x[lane], hit.Ng_y[lane], hit.Ng_z[lane]};
  }
  const auto [a, b, c] = corners_of(mesh, packet.triangle(lane), packet.share(lane));
  return (b - a).cross(c - a);
}

Eigen::Matrix3d inverse_of_intrinsics(const vo::PinholeCamera& camera) {
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  result(0, 0) = 1 / camera.fx;
  result(1, 1) = 1 / camera.fy;
  result(0, 2) = -camera.cx / camera.fx;
  result(1, 2) = -camera.cy / camera.fy;
  return result;
}

}  // namespace

float shadow_reach(const PlacedLight& light) {
  return light.has_place() ? 1 : kInfinity;
}

EmbreeScene::EmbreeScene(const WorldGeometry& world)
    : shadow_coherence_(shadow_coherence(world)), device_(rtcNewDevice(nullptr)) {
  if (device_ == nullptr) {
    const RTCError error = rtcGetDeviceError(nullptr);
    vo::fail_as(error == RTC_ERROR_OUT_OF_MEMORY ? vo::ErrorKind::temporary : vo::ErrorKind::input,
                "Embree: no device, error ", error,
                error == RTC_ERROR_OUT_OF_MEMORY ? ", out of memory" : "");
  }
  std::string error;
  rtcSetDeviceErrorFunction(device_.get(), keep_first_error, &error);
  for (const SharedMesh& shared : world.shared_meshes) {
    shared_.push_back(new_hierarchy());
    attach(shared_.back().get(), triangles_of(device_.get(), world, shared).get(), 0);
    rtcCommitScene(shared_.back().get());
  }
  hierarchy_ = new_hierarchy();
  for (unsigned i = 0; i < world.meshes.size(); ++i) {
    const FlatMesh& mesh = world.meshes[i];
    const EmbreeGeometry geometry =
        mesh.shared == kNone ? triangles_of(device_.get(), world, mesh)
                             : instance_of(device_.get(), shared_[mesh.shared].get(), world, mesh);
    attach(hierarchy_.get(), geometry.get(), i);
  }
  rtcCommitScene(hierarchy_.get());
  rtcSetDeviceErrorFunction(device_.get(), nullptr, nullptr);
  vo::require(error.empty(), "Embree: ", error);
}

EmbreeScene::Hierarchy EmbreeScene::new_hierarchy() const {
  Hierarchy hierarchy(rtcNewScene(device_.get()));
  rtcSetSceneFlags(hierarchy.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(hierarchy.get(), RTC_BUILD_QUALITY_HIGH);
  return hierarchy;
}

void EmbreeScene::intersect(std::vector<RTCRayHit>& rays) const {
  EmbreeQuery query;
  embree_intersect(hierarchy_.get(), query.context, Coherence::coherent, rays);
}

void EmbreeScene::occlude(std::vector<RTCRay>& rays) const {
  EmbreeQuery query;
  embree_occlude(hierarchy_.get(), query.context, shadow_coherence_, rays);
}

void EmbreeScene::intersect(HitPacket& packet, Sight sight) const {
  EmbreeQuery query{.sight = sight};
  const FirstLanes first(packet.size);
  for (int lane = packet.size; lane < kPacketSize; ++lane) {
    set_lane(packet.lanes.ray, lane, {Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()});
    retire_lane(packet.lanes.ray, lane);
  }
  embree_intersect(hierarchy_.get(), query.context, packet.coherence, first.mask.data(),
                   packet.lanes);
}

void EmbreeScene::occlude(ShadowPacket& packet, ShadowHit& occluder, ShadowCasters casters) const {
  EmbreeQuery query{.casters = casters, .occluder = &occluder};
  for (int lane = 0; lane < kPacketSize; ++lane) {
    if (packet.active[static_cast<std::size_t>(lane)] == 0) {
      retire_lane(packet.lanes, lane);
    }
  }
  const bool is_coherent =
      packet.coherence == Coherence::coherent && shadow_coherence_ == Coherence::coherent;
  embree_occlude(hierarchy_.get(), query.context,
                 is_coherent ? Coherence::coherent : Coherence::incoherent, packet.active.data(),
                 packet.lanes);
  const float* const left = packet.lanes.tfar;
  std::transform(packet.active.begin(), packet.active.end(), left, packet.active.begin(),
                 [](int active, float far) { return far < 0 ? 0 : active; });
}

void add_ray(HitPacket& packet, const CameraRay& ray) {
  const int lane = packet.size++;
  set_lane(packet.lanes.ray, lane, ray);
  packet.lanes.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
}

bool has_hit(const RTCRayHit& ray) {
  return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

bool is_occluded(const RTCRay& ray) {
  return ray.tfar < 0;
}

SurfaceHit surface_hit(const RTCHit& hit) {
  return {.mesh = mesh_of(hit.instID[0], hit.geomID),
          .triangle = static_cast<int>(hit.primID),
          .weights = {1 - hit.u - hit.v, hit.u, hit.v}};
}

void aim_along(RTCRayHit& ray, const Eigen::Vector3f& from, const Eigen::Vector3f& direction) {
  set_ray(ray.ray, {from, direction, kNear});
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

void aim_at_light(RTCRay& ray, const SurfacePoint& point, const DirectLight& direct,
                  const PlacedLight& light) {
  set_ray(ray, {point.position + point.rounding * point.face_normal, direct.to_light, 0,
                shadow_reach(light), point.share});
}

ShadowPacket shadow_rays(const LitLanes& lit) {
  ShadowPacket packet{};
  RTCRay16& rays = packet.lanes;
  std::copy_n(lit.start.x.begin(), lit.size, rays.org_x);
  std::copy_n(lit.start.y.begin(), lit.size, rays.org_y);
  std::copy_n(lit.start.z.begin(), lit.size, rays.org_z);
  std::copy_n(lit.scene_share.begin(), lit.size, rays.time);
  std::fill_n(rays.mask, kPacketSize, std::numeric_limits<unsigned>::max());
  return packet;
}

void aim_at_light(ShadowPacket& packet, const LightLanes& direct, float reach) {
  RTCRay16& rays = packet.lanes;
  std::copy(direct.to_light.x.begin(), direct.to_light.x.end(), rays.dir_x);
  std::copy(direct.to_light.y.begin(), direct.to_light.y.end(), rays.dir_y);
  std::copy(direct.to_light.z.begin(), direct.to_light.z.end(), rays.dir_z);
  std::fill_n(rays.tfar, kPacketSize, reach);
  std::transform(direct.share.begin(), direct.share.end(), packet.active.begin(),
                 [](float share) { return share > 0 ? -1 : 0; });
}

std::vector<PixelCell> grid_of_cells(int per_edge) {
  constexpr double kPlastic = 1.32471795724474602596;  // x^3 = x + 1
  std::vector<PixelCell> cells;
  for (int y = 0; y < per_edge; ++y) {
    for (int x = 0; x < per_edge; ++x) {
      cells.push_back({{(x + 0.5) / per_edge - 0.5, (y + 0.5) / per_edge - 0.5},
                       x / kPlastic + y / (kPlastic * kPlastic)});
    }
  }
  return cells;
}

View::View(const WorldGeometry& world, const Capture& capture)
    : world_(world),
      capture_(capture),
      poses_(capture),
      instants_(capture.seed, kInstants, 0),
      pixel_width_(static_cast<float>(capture.camera.pixel_width())) {
  const vo::PinholeCamera* const pinhole = capture.camera.pinhole();
  if (pinhole == nullptr || !pinhole->distortion.is_zero()) {
    return;
  }
  const Eigen::Matrix3d K_inverse = inverse_of_intrinsics(*pinhole);
  const int rows = is_at_rest() ? 1 : pinhole->height;
  for (int v = 0; v < rows; ++v) {
    const CameraPose& camera_pose = poses_.of_row(v);
    ray_generators_.push_back({camera_pose.R_world_camera * K_inverse,
                               (camera_pose.position - world.origin).cast<float>(),
                               share_of_row(v)});
  }
}

/// Returns a pixel's ray direction, world axes: multiples are depths.
Eigen::Vector3d View::direction(const CameraPose& camera_pose, const Eigen::Vector2d& pixel) const {
  return camera_pose.R_world_camera * capture_.camera.ray(pixel);
}

CameraRay View::ray_from(const CameraPose& camera_pose, const Eigen::Vector2d& pixel,
                         float share) const {
  const Eigen::Vector3d along = direction(camera_pose, pixel);
  const Eigen::Vector3f from = (camera_pose.position - world_.origin).cast<float>();
  if (!along.allFinite()) {  // outside the lens's view; a ray without reach hits nothing
    return {from, Eigen::Vector3f::UnitZ(), kNear, 0, share};
  }
  return {from, along.cast<float>(), kNear, kInfinity, share};
}

CameraRay View::ray_from_row(int v, const Eigen::Vector2d& pixel) const {
  if (ray_generators_.empty()) {
    return ray_from(poses_.of_row(v), pixel, share_of_row(v));
  }
  const RayGenerator& generator =
      ray_generators_[ray_generators_.size() == 1 ? 0 : static_cast<std::size_t>(v)];
  const Eigen::Matrix3d& M = generator.direction_from_pixel;
  const Eigen::Vector3d direction = M.col(0) * pixel.x() + M.col(1) * pixel.y() + M.col(2);
  return {generator.start, direction.cast<float>(), kNear, kInfinity, generator.share};
}

void View::aim_at_centre(const cv::Point& pixel, RTCRayHit& ray) const {
  set_ray(ray.ray, ray_from_row(pixel.y, {pixel.x, pixel.y}));
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
}

void View::add_ray_at_centre(const cv::Point& pixel, HitPacket& packet) const {
  add_ray(packet, ray_from_row(pixel.y, {pixel.x, pixel.y}));
}

void View::add_ray_at_cell(const cv::Point& pixel, const PixelCell& cell, HitPacket& packet) const {
  const Eigen::Vector2d place(pixel.x + cell.offset.x(), pixel.y + cell.offset.y());
  if (capture_.shutter.exposure_time == 0) {
    add_ray(packet, ray_from_row(pixel.y, place));
    return;
  }
  const double time = time_of_cell(pixel, cell);
  add_ray(packet, ray_from(poses_.at(time), place, share_at(time)));
}

/// Returns the instant of a pixel's cell within an exposure, s after the stamp.
double View::time_of_cell(const cv::Point& pixel, const PixelCell& cell) const {
  const double turn = instants_.uniform(pixel.x, pixel.y) + cell.instant;
  return capture_.shutter.time_in_row(pixel.y, turn - std::floor(turn), capture_.camera.height());
}

CameraPose View::pose_at_cell(const cv::Point& pixel, const PixelCell& cell) const {
  return capture_.shutter.exposure_time == 0 ? poses_.of_row(pixel.y)
                                             : poses_.at(time_of_cell(pixel, cell));
}

RaySides View::pixel_sides(const cv::Point& pixel) const {
  const auto sides = camera().pixel_sides({pixel.x, pixel.y}).value();
  const Eigen::Matrix3d in_widths = poses_.of_row(pixel.y).R_world_camera / camera().pixel_width();
  return {(in_widths * sides[0]).cast<float>(), (in_widths * sides[1]).cast<float>()};
}

PlaneView View::eye(const cv::Point& pixel) const {
  const CameraPose& camera_pose = poses_.of_row(pixel.y);
  return {camera_pose.position,
          camera().has_optical_axis() ? Eigen::Vector3d(camera_pose.R_world_camera.col(2))
                                      : direction(pixel),
          share_of_row(pixel.y)};
}

DepthPlane View::plane_of(int mesh, int triangle, const cv::Point& pixel) const {
  return depth_plane(world_.meshes[mesh], triangle, eye(pixel));
}

std::optional<double> View::depth_of(const DepthPlane& plane, const cv::Point& pixel) const {
  return plane.depth_along(direction(pixel));
}

float View::exact_depth(const cv::Point& pixel, const RTCRayHit& ray) const {
  const SurfaceHit hit = surface_hit(ray.hit);
  const DepthPlane plane = plane_of(hit.mesh, hit.triangle, pixel);
  const std::optional<double> depth = depth_of(plane, pixel);
  return depth ? static_cast<float>(*depth) : ray.ray.tfar;
}

cv::Vec3f View::normal(const cv::Point& pixel, const HitPacket& packet, int lane) const {
  const Eigen::Vector3f across = across_triangle(world_, packet, lane);
  const Eigen::Vector3f outward =
      across.dot(packet.direction(lane)) > 0 ? Eigen::Vector3f(-across) : across;
  const Eigen::Vector3f unit =
      R_world_camera(pixel.y).transpose().cast<float>() * outward.normalized();
  return {unit.x(), unit.y(), unit.z()};
}

}  // namespace synth
