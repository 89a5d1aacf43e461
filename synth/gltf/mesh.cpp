#include "synth/gltf/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "synth/gltf_document/notes.h"
#include "synth/gltf_model/accessor.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Returns the accessor index of an attribute, or kNone.
int find_attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? kNone : found->second;
}

std::array<int, 3> triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)};
}

/// Assembles corners into triangles by the primitive's mode; drops an incomplete last triangle.
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
    } else {  // every other triangle of a strip has reversed winding
      triangles.push_back(triangle(corners[i - 2], corners[i], corners[i - 1]));
    }
  }
  return triangles;
}

/// Returns the primitive restart index, which glTF reserves: the largest of the indices' type.
std::uint32_t restart_index(const tinygltf::Model& model, int accessor) {
  const int type = model.accessors[static_cast<std::size_t>(accessor)].componentType;
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 0xFFU
         : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 0xFFFFU
                                                          : 0xFFFFFFFFU;
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
  const std::uint32_t restart = restart_index(model, primitive.indices);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    vo::require(corners[i] != restart, place, ": index ", i, " is ", restart,
                ", which restarts a primitive, expected none of these");
    vo::require(corners[i] < vertices, place, ": index ", i, " is ", corners[i],
                ", expected one below the ", vertices, " vertices");
  }
  return corners;
}

/// Reads unit normals; none if one of them is zero.
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

/// Reads unit tangents with handedness w = +-1; none if one has zero length or handedness.
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

void read_attributes(GltfReading& reading, const tinygltf::Primitive& primitive,
                     const std::string& place, Mesh& mesh) {
  const tinygltf::Model& model = reading.model.content;
  const int normal = find_attribute(primitive, "NORMAL");
  if (normal != kNone) {
    mesh.normals = read_normals(model, normal, place + ": NORMAL", reading.notes);
  }
  const int color = find_attribute(primitive, "COLOR_0");
  if (color != kNone) {
    mesh.colors = read_colors(model, color, place + ": COLOR_0");
  }
  const int tangent = find_attribute(primitive, "TANGENT");
  if (tangent != kNone && !mesh.normals.empty()) {
    mesh.tangents = read_tangents(model, tangent, place + ": TANGENT", reading.notes);
  }
  for (std::size_t set = 0; set < mesh.texcoords.size(); ++set) {
    const std::string name = "TEXCOORD_" + std::to_string(set);
    const int texcoords = find_attribute(primitive, name);
    if (texcoords != kNone) {
      mesh.texcoords[set] =
          read_vectors<Eigen::Vector2f>(model, texcoords, vo::concat(place, ": ", name));
    }
  }
}

std::vector<Eigen::Vector3f> read_displacements(const tinygltf::Model& model,
                                                const std::map<std::string, int>& target,
                                                const std::string& name, const std::string& place) {
  const auto found = target.find(name);
  return found == target.end()
             ? std::vector<Eigen::Vector3f>()
             : read_vectors<Eigen::Vector3f>(model, found->second, place + ": " + name);
}

std::vector<MorphTarget> read_targets(GltfReading& reading, const tinygltf::Primitive& primitive,
                                      const std::string& place) {
  const tinygltf::Model& model = reading.model.content;
  std::vector<MorphTarget> targets;
  for (std::size_t i = 0; i < primitive.targets.size(); ++i) {
    const std::map<std::string, int>& source = primitive.targets[i];
    const std::string named = place + ".targets[" + std::to_string(i) + ']';
    targets.push_back({.positions = read_displacements(model, source, "POSITION", named),
                       .normals = read_displacements(model, source, "NORMAL", named),
                       .tangents = read_displacements(model, source, "TANGENT", named)});
    for (const auto& [name, accessor] : source) {
      if (name.compare(0, 9, "TEXCOORD_") == 0 || name.compare(0, 6, "COLOR_") == 0) {
        add_note(reading.notes, "morphing of texture coordinates and colours is left out");
      }
    }
  }
  return targets;
}

/// Returns twice the bytes that reading a primitive allocates, as some of them are copied.
std::size_t memory_of(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  constexpr std::size_t kVertexBytes = 2 * 4 * sizeof(float);
  const auto bytes_of = [&](int accessor) {
    return model.accessors[static_cast<std::size_t>(accessor)].count * kVertexBytes;
  };
  std::size_t bytes = primitive.indices == kNone ? 0 : bytes_of(primitive.indices);
  for (const auto& [name, accessor] : primitive.attributes) {
    bytes += bytes_of(accessor);
  }
  for (const std::map<std::string, int>& target : primitive.targets) {
    for (const auto& [name, accessor] : target) {
      bytes += bytes_of(accessor);
    }
  }
  return bytes;
}

}  // namespace

std::optional<PrimitiveGeometry> read_primitive(GltfReading& reading,
                                                const tinygltf::Primitive& primitive,
                                                const std::string& place) {
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    add_note(reading.notes, "points and lines are left out");
    return std::nullopt;
  }
  const int position = find_attribute(primitive, "POSITION");
  if (position == kNone) {
    add_note(reading.notes, "primitives without POSITION are left out");
    return std::nullopt;
  }
  const tinygltf::Model& model = reading.model.content;
  reading.budget.take(memory_of(model, primitive), place);
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(position)];
  const std::vector<std::uint32_t> corners = read_corners(model, primitive, accessor.count, place);
  if (accessor.bufferView != kNone && !holds_data(model, position)) {
    add_note(reading.notes, "primitives whose POSITION has no data are left out");
    return std::nullopt;
  }
  PrimitiveGeometry geometry;
  Mesh& mesh = geometry.mesh;
  mesh.positions = read_vectors<Eigen::Vector3f>(model, position, place + ": POSITION");
  mesh.triangles = assemble(primitive.mode, corners);
  read_attributes(reading, primitive, place, mesh);
  geometry.targets = read_targets(reading, primitive, place);
  return geometry;
}

}  // namespace synth
