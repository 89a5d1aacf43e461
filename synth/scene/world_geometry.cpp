#include "synth/scene/world_geometry.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/LU>

#include "synth/scene/cofactors.h"
#include "synth/scene/vertex_sample.h"
#include "vo/core/error.h"
#include "vo/geometry/world_extent.h"

namespace synth {
namespace {

const Material kDefaultMaterial;  // for meshes that name none

/// The size, m, of a scene whose middle floats are counted from: half of it is 2^9 m, where they
/// have steps of 0.06 mm at most.
constexpr double kWidest = 1024;

Eigen::Vector3f place_position(const FlatMesh& world, const Eigen::Vector3f& position) {
  const Eigen::Vector3d p_world = world.T_world_mesh * position.cast<double>();
  return (p_world - world.origin).cast<float>();
}

Eigen::Vector3f place_normal(const Eigen::Matrix3d& N, const Eigen::Vector3f& normal) {
  return (N * normal.cast<double>()).normalized().cast<float>();
}

bool is_textured(const Material& material) {
  const auto slots = all_texture_slots(material);
  return std::any_of(slots.begin(), slots.end(),
                     [](const TextureSlot* slot) { return slot->texture != kNone; });
}

/// Returns an instance's flat mesh without vertices.
FlatMesh unplaced(const Scene& scene, std::size_t index) {
  const Instance& instance = scene.instances[index];
  FlatMesh world;
  world.mesh = &scene.meshes[instance.mesh];
  world.instance = static_cast<int>(index);
  world.material = &material_of(scene, *world.mesh);
  world.is_textured = is_textured(*world.material);
  world.T_world_mesh = instance.T_world_mesh;
  world.side = instance.T_world_mesh.linear().determinant() < 0 ? -1.0F : 1.0F;
  return world;
}

Eigen::AlignedBox3d bounds(const FlatMesh& world) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& position : world.mesh->positions) {
    box.extend(world.T_world_mesh * position.cast<double>());
  }
  return box;
}

/// Returns the median, m, world, of each coordinate of the scene's vertices.
Eigen::Vector3d median_vertex(const Scene& scene) {
  const std::vector<Eigen::Vector3d> vertices = sample_vertices(scene);
  Eigen::Vector3d median;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> values(vertices.size());
    std::transform(vertices.begin(), vertices.end(), values.begin(),
                   [axis](const Eigen::Vector3d& vertex) { return vertex[axis]; });
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[axis] = *middle;
  }
  return median;
}

/// Sets the mesh's positions and normals unless its vertices are shared.
void place_vertices(FlatMesh& world) {
  if (world.shared != kNone) {
    return;
  }
  const Mesh& mesh = *world.mesh;
  world.positions.resize(mesh.positions.size() + 1, Eigen::Vector3f::Zero());
  std::transform(mesh.positions.begin(), mesh.positions.end(), world.positions.begin(),
                 [&](const Eigen::Vector3f& position) { return place_position(world, position); });
  const Eigen::Matrix3d N = cofactors(world.T_world_mesh.linear());
  world.normals.resize(mesh.normals.size());
  std::transform(mesh.normals.begin(), mesh.normals.end(), world.normals.begin(),
                 [&](const Eigen::Vector3f& normal) { return place_normal(N, normal); });
}

/// Returns whether transforms or positions differ between moments; shared meshes do not deform.
bool moves_between(const std::vector<FlatMesh>& moments) {
  return std::any_of(moments.begin(), moments.end(), [&](const FlatMesh& moment) {
    return moment.T_world_mesh.matrix() != moments[0].T_world_mesh.matrix() ||
           (moment.shared == kNone && moment.mesh->positions != moments[0].mesh->positions);
  });
}

/// Returns the bounding box of a mesh's vertices, m, in the mesh's coordinates.
Eigen::AlignedBox3d bounds_of(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& position : mesh.positions) {
    box.extend(position.cast<double>());
  }
  return box;
}

/// Throws unless the mesh is within the world at all moments, which an animation may leave.
void require_moments_within_world(const std::vector<FlatMesh>& moments, const FlatMesh& world) {
  const Eigen::AlignedBox3d shape = bounds_of(*world.mesh);
  for (const FlatMesh& moment : moments) {
    const bool is_bent = moment.shared == kNone;
    require_within_world(
        (is_bent ? bounds_of(*moment.mesh) : shape).transformed(moment.T_world_mesh),
        vo::concat("scene: instance ", world.instance, ", which moves"));
  }
}

/// Throws unless the lamps are within the world, which an animation may leave.
void require_lights_within_world(const Scene& scene) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    require_within_world(Eigen::AlignedBox3d(scene.lights[i].position),
                         vo::concat("scene: light ", i));
  }
}

void add_moments(const std::vector<Scene>& scenes, FlatMesh& world) {
  std::vector<FlatMesh> moments;
  for (const Scene& scene : scenes) {
    FlatMesh& moment =
        moments.emplace_back(unplaced(scene, static_cast<std::size_t>(world.instance)));
    moment.origin = world.origin;
    moment.shared = world.shared;
  }
  if (moves_between(moments)) {
    require_moments_within_world(moments, world);
    std::for_each(moments.begin(), moments.end(), place_vertices);
    world.moments = std::move(moments);
  }
}

/// Makes the instances that need no vertices of their own refer to shared meshes.
void share_meshes(const std::vector<Scene>& moments, WorldGeometry& world) {
  const std::vector<bool> sharing = sharing_instances(*world.scene, moments);
  std::vector<int> shared_of_mesh(world.scene->meshes.size(), kNone);
  for (FlatMesh& mesh : world.meshes) {
    if (!sharing[static_cast<std::size_t>(mesh.instance)]) {
      continue;
    }
    int& shared = shared_of_mesh[static_cast<std::size_t>(mesh.mesh - world.scene->meshes.data())];
    if (shared == kNone) {
      shared = static_cast<int>(world.shared_meshes.size());
      world.shared_meshes.push_back(shared_mesh(*mesh.mesh));
    }
    mesh.shared = shared;
  }
}

WorldGeometry flatten(const Scene& scene, const std::vector<Scene>& moments) {
  WorldGeometry world;
  world.scene = &scene;
  require_lights_within_world(scene);
  std::for_each(moments.begin(), moments.end(), require_lights_within_world);
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const int mesh = scene.instances[i].mesh;
    if (mesh != kNone && !scene.meshes[mesh].triangles.empty()) {
      world.meshes.push_back(unplaced(scene, i));
      const Eigen::AlignedBox3d own = bounds(world.meshes.back());
      require_within_world(own, vo::concat("scene: instance ", i));
      box.extend(own);
    }
  }
  if (!box.isEmpty()) {
    const bool is_wide = box.sizes().maxCoeff() > kWidest;
    world.origin = is_wide ? median_vertex(scene) : Eigen::Vector3d(box.center());
  }
  share_meshes(moments, world);
  for (FlatMesh& mesh : world.meshes) {
    mesh.origin = world.origin;
    place_vertices(mesh);
    add_moments(moments, mesh);
  }
  return world;
}

Eigen::Vector3d corner_of(const FlatMesh& mesh, int vertex) {
  return mesh.T_world_mesh * mesh.mesh->positions[vertex].cast<double>();
}

}  // namespace

void require_within_world(const Eigen::AlignedBox3d& box, const std::string& place) {
  const Eigen::Array3d reach = box.min().array().abs().max(box.max().array().abs());
  // A coordinate that is no number fails this comparison, too.
  vo::require(box.isEmpty() || (reach <= vo::kMaxMetres).all(), place, ": reaches ",
              reach.maxCoeff(), " m from the origin, expected at most ", vo::kMaxMetres);
}

void require_within_world(const Scene& scene,
                          const std::function<std::string(std::size_t)>& place_of) {
  std::vector<Eigen::AlignedBox3d> boxes(scene.meshes.size());
  std::transform(scene.meshes.begin(), scene.meshes.end(), boxes.begin(), bounds_of);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Eigen::AlignedBox3d& own = boxes[static_cast<std::size_t>(instance.mesh)];
    require_within_world(own.transformed(instance.T_world_mesh), place_of(i));
  }
}

const Material& material_of(const Scene& scene, const Mesh& mesh) {
  return mesh.material == kNone ? kDefaultMaterial : scene.materials[mesh.material];
}

Eigen::Vector3f FlatMesh::position(int vertex) const {
  return shared == kNone ? positions[vertex] : place_position(*this, mesh->positions[vertex]);
}

Eigen::Vector3f FlatMesh::normal(int vertex) const {
  return shared == kNone ? normals[vertex]
                         : place_normal(cofactors(T_world_mesh.linear()), mesh->normals[vertex]);
}

WorldGeometry flatten(const Scene& scene) {
  return flatten(scene, {});
}

WorldGeometry flatten(const SceneDuring& during) {
  WorldGeometry world = flatten(during.now, during.moments);
  world.begin = during.begin;
  world.end = during.end;
  return world;
}

float WorldGeometry::share_at(double time) const {
  return end > begin ? static_cast<float>(std::clamp((time - begin) / (end - begin), 0.0, 1.0)) : 0;
}

MomentPair moments_around(const FlatMesh& mesh, float share) {
  if (mesh.moments.empty()) {
    return {&mesh, &mesh, 0};
  }
  const std::size_t intervals = mesh.moments.size() - 1;
  const float place = share * static_cast<float>(intervals);
  const std::size_t before = std::min(static_cast<std::size_t>(place), intervals - 1);
  return {&mesh.moments[before], &mesh.moments[before + 1], place - static_cast<float>(before)};
}

std::array<Eigen::Vector3f, 3> corners_of(const FlatMesh& mesh, int triangle, float share) {
  const MomentPair moments = moments_around(mesh, share);
  const std::array<int, 3>& vertices = mesh.mesh->triangles[triangle];
  std::array<Eigen::Vector3f, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = moments.before->position(vertices[i]);
    if (moments.share != 0) {
      corners[i] += moments.share * (moments.after->position(vertices[i]) - corners[i]);
    }
  }
  return corners;
}

std::array<Eigen::Vector3d, 3> world_corners(const FlatMesh& mesh, int triangle) {
  std::array<Eigen::Vector3d, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const int vertex = mesh.mesh->triangles[triangle][i];
    corners[i] = mesh.T_world_mesh * mesh.mesh->positions[vertex].cast<double>();
  }
  return corners;
}

Eigen::Affine3d T_flat_shared(const WorldGeometry& world, const FlatMesh& mesh) {
  return Eigen::Translation3d(-world.origin) * mesh.T_world_mesh *
         Eigen::Translation3d(world.shared_meshes[mesh.shared].centre);
}

Eigen::AlignedBox3d visible_bounds(const WorldGeometry& world) {
  Eigen::AlignedBox3d box;
  for (const FlatMesh& mesh : world.meshes) {
    box.extend(bounds(mesh));
  }
  return box;
}

DepthPlane depth_plane(const FlatMesh& mesh, int triangle, const PlaneView& view) {
  constexpr double kTolerance = 1e-6;      // relative; the hit was found in single precision
  std::array<Eigen::Vector3d, 3> corners;  // from the eye, m
  Eigen::Vector3d depths;
  const MomentPair moments = moments_around(mesh, view.share);
  const double share = moments.share;
  for (int i = 0; i < 3; ++i) {
    const int vertex = mesh.mesh->triangles[triangle][i];
    corners[i] = corner_of(*moments.before, vertex) - view.eye;
    if (share > 0) {
      corners[i] += share * (corner_of(*moments.after, vertex) - view.eye - corners[i]);
    }
    depths[i] = corners[i].dot(view.depth_axis);
  }
  const double margin = kTolerance * depths.cwiseAbs().maxCoeff();
  DepthPlane plane;
  plane.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  plane.offset = plane.normal.dot(corners[0]);
  plane.nearest = depths.minCoeff() - margin;
  plane.farthest = depths.maxCoeff() + margin;
  return plane;
}

std::optional<double> DepthPlane::depth_along(const Eigen::Vector3d& direction) const {
  const double depth = offset / normal.dot(direction);
  return depth >= nearest && depth <= farthest ? std::optional(depth) : std::nullopt;
}

Eigen::AlignedBox3d lit_bounds(const WorldGeometry& world) {
  Eigen::AlignedBox3d box;
  for (const FlatMesh& mesh : world.meshes) {
    if (!mesh.material->unlit) {
      box.extend(bounds(mesh));
    }
  }
  return box;
}

}  // namespace synth
