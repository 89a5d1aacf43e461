#include "synth/rasterization/gl_scene.h"

#include <cstddef>

namespace synth {
namespace {

constexpr GLuint kTexcoords = 2;  // location of the first of two sets
constexpr GLuint kTangent = 5;

/// Uploads an attribute of the current vertex array; does nothing if the mesh has no values.
template <typename Value>
void add_attribute(const GlFunctions& gl, GLuint location, const std::vector<Value>& values) {
  if (values.empty()) {
    return;
  }
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Value)),
                values.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(location, Value::SizeAtCompileTime, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(location);
}

/// Returns a new vertex array object of a mesh, with the given positions and normals.
GLuint upload(const GlFunctions& gl, const Mesh& mesh,
              const std::vector<Eigen::Vector3f>& positions,
              const std::vector<Eigen::Vector3f>& normals) {
  GLuint vertices = 0;
  gl.GenVertexArrays(1, &vertices);
  gl.BindVertexArray(vertices);
  add_attribute(gl, 0, positions);
  add_attribute(gl, 1, normals);
  for (GLuint set = 0; set < kTexcoordSets; ++set) {
    add_attribute(gl, kTexcoords + set, mesh.texcoords[set]);
  }
  add_attribute(gl, kColorAttribute, mesh.colors);
  add_attribute(gl, kTangent, mesh.tangents);
  GLuint indices = 0;
  gl.GenBuffers(1, &indices);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(mesh.triangles[0])),
                mesh.triangles.data(), GL_STATIC_DRAW);
  return vertices;
}

Eigen::AlignedBox3f bounds_of(const FlatMesh& world) {
  Eigen::AlignedBox3f bounds;
  for (std::size_t i = 0; i < world.mesh->positions.size(); ++i) {
    bounds.extend(world.position(static_cast<int>(i)));
  }
  return bounds;
}

GLint wrap_of(Wrap wrap) {
  return wrap == Wrap::repeat          ? GL_REPEAT
         : wrap == Wrap::clamp_to_edge ? GL_CLAMP_TO_EDGE
                                       : GL_MIRRORED_REPEAT;
}

GLint minification_of(const Texture& texture) {
  const bool is_linear = texture.minification == TexelFilter::linear;
  switch (texture.mip) {
    case MipFilter::none:
      return is_linear ? GL_LINEAR : GL_NEAREST;
    case MipFilter::nearest:
      return is_linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    case MipFilter::linear:
      break;
  }
  return is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
}

/// Uploads a texture with the mip levels of `image`, so that both renderers filter alike.
GLuint upload(const GlFunctions& gl, const Texture& texture, const TextureImage& image) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLint format = image.encoding == TexelEncoding::srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  for (std::size_t i = 0; i < image.levels.size(); ++i) {
    const cv::Mat_<cv::Vec4b> level =
        image.levels[i].isContinuous() ? image.levels[i] : image.levels[i].clone();
    gl.TexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), format, level.cols, level.rows, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, level.data);
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL,
                   static_cast<GLint>(image.levels.size()) - 1);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(texture.wrap_u));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(texture.wrap_v));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minification_of(texture));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                   texture.magnification == TexelFilter::linear ? GL_LINEAR : GL_NEAREST);
  return name;
}

}  // namespace

GlScene upload(const GlFunctions& gl, const WorldGeometry& world) {
  GlScene made;
  std::vector<GLuint> shared;
  for (const SharedMesh& mesh : world.shared_meshes) {
    shared.push_back(upload(gl, *mesh.mesh, mesh.positions, mesh.mesh->normals));
  }
  for (const FlatMesh& mesh : world.meshes) {
    made.meshes.push_back({.vertices = mesh.shared == kNone
                                           ? upload(gl, *mesh.mesh, mesh.positions, mesh.normals)
                                           : shared[static_cast<std::size_t>(mesh.shared)],
                           .indices = static_cast<GLsizei>(3 * mesh.mesh->triangles.size()),
                           .world = &mesh,
                           .bounds = bounds_of(mesh)});
  }
  for (const Texture& texture : world.scene->textures) {
    made.textures.push_back(
        texture.image == kNone ? 0 : upload(gl, texture, world.scene->images[texture.image]));
  }
  return made;
}

}  // namespace synth
