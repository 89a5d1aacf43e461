#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "synth/rasterization/gl_functions.h"
#include "synth/scene/world_geometry.h"

namespace synth {

inline constexpr GLuint kColorAttribute = 4;  ///< location of vertex colours in kVertexShader

/// The OpenGL objects of a mesh.
struct GlMesh {
  GLuint vertices = 0;  ///< vertex array object
  GLsizei indices = 0;
  const FlatMesh* world = nullptr;
  Eigen::AlignedBox3f bounds;  ///< m, in the world-space geometry's coordinates
};

/// The OpenGL objects of a world-space geometry, valid as long as their context.
struct GlScene {
  std::vector<GlMesh> meshes;
  std::vector<GLuint> textures;  ///< one for each of Scene::textures, 0 without an image
};

/// Uploads a world-space geometry to the current context, with kVertexShader's attribute locations.
GlScene upload(const GlFunctions& gl, const WorldGeometry& world);

}  // namespace synth
