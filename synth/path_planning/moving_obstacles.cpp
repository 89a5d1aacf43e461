#include "synth/path_planning/moving_obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "synth/scene/scene_motion.h"

namespace synth {
namespace {

/// Returns whether a step crosses a triangle (Moller & Trumbore, Fast, minimum storage ray/triangle
/// intersection, 1997).
bool crosses(const TimedStep& step, const std::array<Eigen::Vector3d, 3>& corners) {
  const Eigen::Vector3d way = step.to - step.from;
  const Eigen::Vector3d a = corners[1] - corners[0];
  const Eigen::Vector3d b = corners[2] - corners[0];
  const Eigen::Vector3d across = way.cross(b);
  const double determinant = a.dot(across);
  if (determinant == 0) {
    return false;
  }
  const Eigen::Vector3d start = step.from - corners[0];
  const double u = start.dot(across) / determinant;
  const Eigen::Vector3d turned = start.cross(a);
  const double v = way.dot(turned) / determinant;
  const double share = b.dot(turned) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && share >= 0 && share <= 1;
}

bool crosses(const TimedStep& step, const Mesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = mesh.positions[static_cast<std::size_t>(triangle[i])].template cast<double>();
    }
    return crosses(step, corners);
  });
}

double last_key(const SceneMotion& motion) {
  double last = 0;
  for (const Animation& animation : motion.animations) {
    last = std::max(last, animation.duration);
  }
  return last;
}

/// Adds a copy of an instance of one scene, and of its mesh, to another scene.
void add_copy(const Scene& from, std::size_t index, Scene& to) {
  Instance copy = from.instances[index];
  if (copy.mesh != kNone) {
    to.meshes.push_back(from.meshes[static_cast<std::size_t>(copy.mesh)]);
    copy.mesh = static_cast<int>(to.meshes.size()) - 1;
    to.instances.push_back(copy);
  }
}

}  // namespace

Scene with_traces(const Scene& scene, double duration) {
  constexpr double kInterval = 0.25;  // s
  constexpr double kMost = 64;        // greatest number of copies
  const std::vector<bool> moving = moving_instances(scene);
  const double end = std::min(duration, last_key(scene.motion));
  const double count = std::clamp(std::ceil(end / kInterval), 0.0, kMost);
  Scene result = scene_at(scene, 0);
  for (int trace = 1; trace <= count; ++trace) {
    const Scene then = scene_at(scene, end * trace / count);
    for (std::size_t i = 0; i < moving.size(); ++i) {
      if (moving[i]) {
        add_copy(then, i, result);
      }
    }
  }
  return result;
}

bool is_struck(const Scene& before, const Scene& after, const std::vector<bool>& moving,
               const TimedStep& step) {
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Instance& instance = before.instances[i];
    if (!moving[i] || instance.mesh == kNone) {
      continue;
    }
    const Eigen::Affine3d& T_world_after = after.instances[i].T_world_mesh;
    if (instance.T_world_mesh.linear().determinant() == 0 ||
        T_world_after.linear().determinant() == 0) {
      continue;
    }
    const TimedStep in_mesh{instance.T_world_mesh.inverse() * step.from,
                            T_world_after.inverse() * step.to};
    if (crosses(in_mesh, before.meshes[static_cast<std::size_t>(instance.mesh)])) {
      return true;
    }
  }
  return false;
}

}  // namespace synth
