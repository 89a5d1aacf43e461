#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "synth/scene/animation.h"

namespace synth {

/// A node of glTF's hierarchy. Its local transform at rest is `T_parent_node`; an animation channel
/// of translation, rotation or scale composes it anew from these three.
struct MotionNode {
  int parent = -1;  ///< index of the parent, which precedes its children; -1 = world
  Eigen::Affine3d T_parent_node = Eigen::Affine3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  std::vector<float> weights;  ///< weights of the morph targets of the node's mesh
};

/// The displacements that a morph target of weight 1 adds to each vertex's attributes; an empty
/// array leaves its attribute unchanged.
struct MorphTarget {
  std::vector<Eigen::Vector3f> positions, normals, tangents;
};

/// The joints of a skin that each vertex follows, with their weights.
struct VertexJoints {
  std::vector<std::array<int, 4>> joints;  ///< indices into Skin::joints; `sets` rows per vertex
  std::vector<Eigen::Vector4f> weights;    ///< parallel to `joints`; a vertex's weights sum to 1
  int sets = 0;
};

/// The vertices of a mesh primitive before morphing and skinning.
struct MeshShape {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<Eigen::Vector4f> tangents;
  std::vector<MorphTarget> targets;
  VertexJoints followed;
};

struct Skin {
  std::vector<int> joints;                    ///< indices into SceneMotion::nodes
  std::vector<Eigen::Affine3d> T_joint_mesh;  ///< inverse bind matrix of each joint
};

/// One of Scene::meshes that is morphed or skinned, and its only instance.
struct DeformableMesh {
  int instance = -1;
  int shape = -1;
  int node = -1;  ///< index of the node whose morph weights apply
  int skin = -1;  ///< index into SceneMotion::skins; -1 = only morphed
};

/// The two factors of a light's intensity or of a material's emission.
struct Brightness {
  Eigen::Vector3f color = Eigen::Vector3f::Ones();  ///< linear RGB
  float strength = 1;
};

/// The motion of a scene over time (see scene_motion.h). Empty for a static scene.
struct SceneMotion {
  std::vector<MotionNode> nodes;
  std::vector<Animation> animations;  ///< all play together from time 0
  std::vector<int> instance_nodes;    ///< node of each of Scene::instances
  std::vector<int> light_nodes;       ///< node of each of Scene::lights
  std::vector<int> camera_nodes;      ///< node of each of Scene::cameras
  std::vector<MeshShape> shapes;
  std::vector<Skin> skins;
  std::vector<DeformableMesh> deforming;
  std::vector<Brightness>
      light_brightness;              ///< of Scene::lights; empty if no animation changes any
  std::vector<Brightness> emission;  ///< of Scene::materials; empty if no animation changes any
  bool loop = false;  ///< animations restart at their end instead of holding their last pose
};

}  // namespace synth
