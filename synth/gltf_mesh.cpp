#include "synth/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "synth/gltf_accessor.h"
#include "synth/gltf_notes.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// The accessor of an attribute, or kNone.
int find_attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? kNone : found->second;
}

std::array<int, 3> triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)};
}

/// Corners of triangles as the mode arranges them; an incomplete last triangle is dropped.
Triangles assemble(int mode, const std::vector<std::uint32_t>& corners) {
  Triangles triangles;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    triangles.reserve(corners.size() / 3);
    for (std::size_t i = 2; i < corners.size(); i += 3) {
      triangles.push_back(triangle(corners[i - 2], corners[i - 1], corners[i]));
    }
    return triangles;
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      triangles.push_back(triangle(corners[i - 1], corners[i], corners[0]));
    } else if (i % 2 == 0) {
      triangles.push_back(triangle(corners[i - 2], corners[i - 1], corners[i]));
    } else {  // every other triangle of a strip turns the other way
      triangles.push_back(triangle(corners[i - 2], corners[i], corners[i - 1]));
    }
  }
  return triangles;
}

std::vector<std::uint32_t> read_corners(const tinygltf::Model& model,
                                        const tinygltf::Primitive& primitive, std::size_t vertices,
                                        const std::string& place) {
  std::vector<std::uint32_t> corners(vertices);
  if (primitive.indices == kNone) {
    std::iota(corners.begin(), corners.end(), 0U);
    return corners;
  }
  corners = read_indices(model, primitive.indices, place);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    vo::require(corners[i] < vertices, place, ": index ", i, " is ", corners[i],
                ", expected one below the ", vertices, " vertices");
  }
  return corners;
}

/// Unit normals, or none if one has no direction.
std::vector<Eigen::Vector3f> read_normals(const tinygltf::Model& model, int accessor,
                                          const std::string& place, Notes& notes) {
  std::vector<Eigen::Vector3f> normals = read_vectors<Eigen::Vector3f>(model, accessor, place);
  for (Eigen::Vector3f& normal : normals) {
    const float length = normal.stableNorm();
    if (!(length > 0)) {
      add_note(notes, "normals of meshes with zero normals are left out");
      return {};
    }
    normal /= length;
  }
  return normals;
}

std::vector<Eigen::Vector4f> read_colors(const tinygltf::Model& model, int accessor,
                                         const std::string& place) {
  if (model.accessors[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC4) {
    return read_vectors<Eigen::Vector4f>(model, accessor, place);
  }
  std::vector<Eigen::Vector4f> colors;
  for (const Eigen::Vector3f& rgb : read_vectors<Eigen::Vector3f>(model, accessor, place)) {
    colors.emplace_back(rgb.homogeneous());
  }
  return colors;
}

/// Unit, each with its handedness; none if one has no direction or no handedness.
std::vector<Eigen::Vector4f> read_tangents(const tinygltf::Model& model, int accessor,
                                           const std::string& place, Notes& notes) {
  auto tangents = read_vectors<Eigen::Vector4f>(model, accessor, place);
  for (Eigen::Vector4f& tangent : tangents) {
    const float length = tangent.head<3>().stableNorm();
    if (!(length > 0) || tangent.w() == 0) {
      add_note(notes, "tangents of meshes with zero tangents are left out");
      return {};
    }
    tangent.head<3>() /= length;
    tangent.w() = std::copysign(1.0F, tangent.w());
  }
  return tangents;
}

void read_attributes(const GltfModel& model, const tinygltf::Primitive& primitive,
                     const std::string& place, Mesh& mesh, Notes& notes) {
  const int normal = find_attribute(primitive, "NORMAL");
  if (normal != kNone) {
    mesh.normals = read_normals(model.content, normal, place + ": NORMAL", notes);
  }
  const int color = find_attribute(primitive, "COLOR_0");
  if (color != kNone) {
    mesh.colors = read_colors(model.content, color, place + ": COLOR_0");
  }
  const int tangent = find_attribute(primitive, "TANGENT");
  if (tangent != kNone && !mesh.normals.empty()) {
    mesh.tangents = read_tangents(model.content, tangent, place + ": TANGENT", notes);
  }
  for (std::size_t set = 0; set < mesh.texcoords.size(); ++set) {
    const std::string name = "TEXCOORD_" + std::to_string(set);
    const int texcoords = find_attribute(primitive, name);
    if (texcoords != kNone) {
      mesh.texcoords[set] =
          read_vectors<Eigen::Vector2f>(model.content, texcoords, place + ": " + name);
    }
  }
}

}  // namespace

std::optional<Mesh> read_primitive(const GltfModel& model, const tinygltf::Primitive& primitive,
                                   const std::string& place, Notes& notes) {
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    add_note(notes, "points and lines are left out");
    return std::nullopt;
  }
  const int position = find_attribute(primitive, "POSITION");
  if (position == kNone) {
    add_note(notes, "primitives without POSITION are left out");
    return std::nullopt;
  }
  if (!primitive.targets.empty()) {
    add_note(notes, "morph targets are left out");
  }
  Mesh mesh;
  mesh.positions = read_vectors<Eigen::Vector3f>(model.content, position, place + ": POSITION");
  mesh.triangles = assemble(primitive.mode,
                            read_corners(model.content, primitive, mesh.positions.size(), place));
  read_attributes(model, primitive, place, mesh, notes);
  return mesh;
}

}  // namespace synth
