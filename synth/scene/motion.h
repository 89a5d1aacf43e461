#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/animation.h"

namespace synth {

/// A frame of the file's hierarchy. At rest it is where `T_parent_node` puts it; a channel of
/// translation, rotation or scale has it put together from the three.
struct MotionNode {
  int parent = -1;  ///< comes before its children; -1 = the world
  Eigen::Affine3d T_parent_node = Eigen::Affine3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  std::vector<float> weights;  ///< of the morph targets of its mesh
};

/// What a morph target of weight 1 adds to each vertex; empty where it leaves them.
struct MorphTarget {
  std::vector<Eigen::Vector3f> positions, normals, tangents;
};

/// The joints that a vertex follows, and how much.
struct VertexJoints {
  std::vector<std::array<int, 4>> joints;  ///< of the skin; `sets` after one another per vertex
  std::vector<Eigen::Vector4f> weights;    ///< those of a vertex sum to 1
  int sets = 0;
};

/// The vertices of a primitive before anything deforms them.
struct MeshShape {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Eigen::Vector4f> tangents;
  std::vector<MorphTarget> targets;
  VertexJoints followed;
};

struct Skin {
  std::vector<int> joints;                    ///< of SceneMotion::nodes
  std::vector<Eigen::Affine3d> T_joint_mesh;  ///< when the skin was bound
};

/// One of Scene::meshes that deforms, and its only instance.
struct DeformableMesh {
  int instance = -1;
  int shape = -1;
  int node = -1;  ///< whose morph weights it follows
  int skin = -1;  ///< -1 = only morphs
};

/// How a scene moves: see scene_motion.h. Empty where nothing does.
struct SceneMotion {
  std::vector<MotionNode> nodes;
  std::vector<Animation> animations;  ///< play together, all from time 0
  std::vector<int> instance_nodes;    ///< the node of each of Scene::instances
  std::vector<int> light_nodes;       ///< of each of Scene::lights
  std::vector<int> camera_nodes;      ///< of each of Scene::cameras
  std::vector<MeshShape> shapes;
  std::vector<Skin> skins;
  std::vector<DeformableMesh> deforming;
  bool loop = false;  ///< each animation starts again at its end instead of holding still
};

}  // namespace synth
