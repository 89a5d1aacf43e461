#pragma once

#include <utility>

#include <Eigen/Core>

#include "synth/scene/scene.h"

namespace support {

/// A closed room around the origin, its walls' fronts inside, x from -2 to 2, y from -1.5 to 1.5,
/// z from -2.5 to 2.5 m. One wall, z = -2.5, is tiled black and white, the others are grey.
inline const Eigen::Vector3d kBoxRoomHalf(2, 1.5, 2.5);

/// Distance of a place in the room to its walls, m.
inline double distance_to_walls(const Eigen::Vector3d& p) {
  return (kBoxRoomHalf - p.cwiseAbs()).minCoeff();
}

/// Counter-clockwise seen from the side that right x down points away from.
inline void add_rectangle(synth::Scene& scene, const Eigen::Vector3f& corner,
                          const Eigen::Vector3f& right, const Eigen::Vector3f& down, float grey) {
  synth::Mesh mesh;
  mesh.positions = {corner, corner + down, corner + right + down, corner + right};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.material = static_cast<int>(scene.materials.size());
  synth::Material material;
  material.base_color << grey, grey, grey, 1;
  material.unlit = true;
  material.double_sided = true;
  scene.materials.push_back(material);
  synth::Instance instance;
  instance.mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
}

inline void add_tiled_wall(synth::Scene& scene) {
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 8; ++column) {
      const Eigen::Vector3f corner(-2 + 0.5F * static_cast<float>(column),
                                   1.5F - 0.5F * static_cast<float>(row), -2.5F);
      add_rectangle(scene, corner, {0.5F, 0, 0}, {0, -0.5F, 0},
                    (row + column) % 2 == 0 ? 0.8F : 0.02F);
    }
  }
}

inline synth::Scene box_room() {
  synth::Scene scene;
  const Eigen::Vector3f low = -kBoxRoomHalf.cast<float>();
  const Eigen::Vector3f high = -low;
  const Eigen::Vector3f x(4, 0, 0);
  const Eigen::Vector3f y(0, 3, 0);
  const Eigen::Vector3f z(0, 0, 5);
  constexpr float kGrey = 0.3F;
  add_tiled_wall(scene);
  add_rectangle(scene, high, -x, -y, kGrey);  // z = 2.5
  add_rectangle(scene, {high.x(), high.y(), low.z()}, z, -y, kGrey);
  add_rectangle(scene, {low.x(), high.y(), high.z()}, -z, -y, kGrey);
  add_rectangle(scene, low, x, z, kGrey);  // floor
  add_rectangle(scene, {low.x(), high.y(), high.z()}, x, -z, kGrey);
  return scene;
}

}  // namespace support
