#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "tools/make_scenes/model/shape.h"
#include "tools/make_scenes/painting/finish.h"

namespace scenes {

/// The triangles of one material.
struct MeshPart {
  Finish finish = Finish::oak;
  Shape shape;
};

struct Mesh {
  std::string name;
  std::vector<MeshPart> parts;
};

/// Adds a shape, placed by T_mesh_shape, to the mesh's part of that finish.
void add(Mesh& mesh, Finish finish, const Shape& shape,
         const Eigen::Isometry3d& T_mesh_shape = Eigen::Isometry3d::Identity());

enum class LightKind { point, directional };

struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  Color color = Color::Ones();  ///< linear RGB
  double intensity = 1;         ///< cd (point), lx (directional, shines along the node's -z)
};

/// Joints that bend a mesh. In the pose that it is bound in, their axes are the mesh's.
struct Skin {
  std::string name;
  std::vector<int> joints;                      ///< nodes
  std::vector<Eigen::Vector3d> joints_in_mesh;  ///< m, where they are in that pose
};

inline constexpr int kNone = -1;

struct Node {
  std::string name;
  int mesh = kNone;
  int light = kNone;
  int skin = kNone;
  Eigen::Isometry3d T_parent_node = Eigen::Isometry3d::Identity();
  double scale = 1;
  std::vector<int> children = {};
};

/// Poses of a node at given times, interpolated linearly between them.
struct Motion {
  int node = kNone;
  std::vector<double> times;  ///< s
  std::vector<Eigen::Isometry3d> T_parent_node;
};

/// A scene in glTF's structure: a tree of nodes that show meshes, which may be shared.
struct Model {
  std::string name;  ///< name of the scene, its folder and its files
  std::vector<Mesh> meshes;
  std::vector<Light> lights;
  std::vector<Skin> skins;
  std::vector<Node> nodes;
  std::vector<int> roots;  ///< nodes without a parent
  std::vector<Motion> motions;
};

}  // namespace scenes
