#pragma once

#include <utility>

#include "synth/camera/make_renderer.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"

namespace synth {

/// A parallelogram from its top-left corner, with glTF's texture coordinates of a full image.
inline Mesh quad(const Eigen::Vector3f& corner, const Eigen::Vector3f& right,
                 const Eigen::Vector3f& down) {
  Mesh mesh;
  mesh.positions = {corner, corner + right, corner + right + down, corner + down};
  mesh.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A square across the optical axis of a camera at the world's origin, seen upright.
inline Mesh square_at(float depth, float half_width) {
  return quad({-half_width, -half_width, depth}, {2 * half_width, 0, 0}, {0, 2 * half_width, 0});
}

/// Puts a mesh into the scene as it stands.
inline void add(Scene& scene, Mesh mesh, const Material& material) {
  mesh.material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(material);
  Instance instance;
  instance.mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
}

inline Material unlit(const Eigen::Vector3f& color) {
  Material material;
  material.base_color << color, 1;
  material.unlit = true;
  return material;
}

/// A red square in front of a green one, 1 and 2 m away.
inline Scene red_before_green(AlphaMode mode, float alpha) {
  Scene scene;
  Material red = unlit({1, 0, 0});
  red.alpha_mode = mode;
  red.base_color.w() = alpha;
  add(scene, square_at(1, 2), red);
  add(scene, square_at(2, 4), unlit({0, 1, 0}));
  return scene;
}

inline Material diffuse(const Eigen::Vector3f& color) {
  Material material = unlit(color);
  material.unlit = false;
  return material;
}

inline Light point_light(const Eigen::Vector3d& position, const Eigen::Vector3f& candela) {
  Light light;
  light.position = position;
  light.intensity = candela;
  return light;
}

/// 90 degrees wide; the optical axis passes through pixel (32, 24).
inline vo::PinholeCamera wide_camera() {
  return vo::PinholeCamera::from_horizontal_fov(65, 49, 90);
}

inline RenderedFrame render(const Scene& scene, const RenderOptions& options,
                            const vo::PinholeCamera& camera = wide_camera(),
                            const vo::SE3& T_world_camera = {}) {
  return make_renderer(scene, options)->render(camera, T_world_camera);
}

}  // namespace synth
