#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

#include "synth/rasterization/gl_functions.h"
#include "synth/scene/world_geometry.h"

namespace synth {

inline constexpr GLuint kColorAttribute = 4;  ///< of a vertex, as the shader numbers them

/// A mesh as OpenGL draws it.
struct GlMesh {
  GLuint vertices = 0;  ///< vertex array object
  GLsizei indices = 0;
  const FlatMesh* world = nullptr;
  Eigen::AlignedBox3f bounds;  ///< m, in the world-space geometry's coordinates
};

/// A world-space geometry in the context that is current; gone when the context is.
struct GlScene {
  std::vector<GlMesh> meshes;
  std::vector<GLuint> textures;  ///< one per Scene::textures, 0 without an image
};

/// Vertex attributes as kVertexShader numbers them.
GlScene upload(const GlFunctions& gl, const WorldGeometry& world);

}  // namespace synth
