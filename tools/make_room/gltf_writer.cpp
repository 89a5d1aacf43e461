#include "tools/make_room/gltf_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "tools/make_room/gltf_materials.h"
#include "tools/make_room/json_text.h"
#include "vo/core/error.h"
#include "vo/io/output.h"
#include "vo/io/png.h"

namespace room {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126;
constexpr int kUnsignedByte = 5121;
constexpr int kUnsignedShort = 5123;

/// The parts of the buffer, one buffer view each, in this order.
enum View : std::size_t { positions, normals, texcoords, colors, indices, view_count };

/// Rounded to 1 / `grid`, so that no machine's mathematical library shows in the file.
double snapped(double value, double grid) {
  return std::floor(value * grid + 0.5) / grid;
}

constexpr double kGrid = 65536;     // positions, m, and texture coordinates
constexpr double kUnitGrid = 4096;  // components of unit vectors

/// The file under construction.
struct Document {
  Json json;
  std::array<std::string, view_count> views;
};

template <typename Scalar>
void write_little_endian(std::string& bytes, Scalar value) {
  static_assert(sizeof(Scalar) <= sizeof(std::uint32_t));
  for (std::size_t i = 0; i < sizeof(Scalar); ++i) {
    bytes.push_back(static_cast<char>(value >> (8 * i) & 255U));
  }
}

void write_float(std::string& bytes, double value, double grid) {
  const auto number = static_cast<float>(snapped(value, grid));
  std::uint32_t bits = 0;
  static_assert(sizeof(bits) == sizeof(number));
  std::copy_n(reinterpret_cast<const char*>(&number), sizeof(bits), reinterpret_cast<char*>(&bits));
  write_little_endian(bytes, bits);
}

int add_accessor(Document& document, View view, std::size_t offset, std::size_t count,
                 const Json& format) {
  Json accessor = {{"bufferView", static_cast<int>(view)}, {"byteOffset", offset}};
  accessor.update(format);
  accessor["count"] = count;
  document.json["accessors"].push_back(accessor);
  return static_cast<int>(document.json["accessors"].size()) - 1;
}

int write_positions(Document& document, const Shape& shape) {
  std::string& bytes = document.views[positions];
  const std::size_t offset = bytes.size();
  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9);
  Eigen::Vector3d high = -low;
  for (const Eigen::Vector3d& position : shape.positions) {
    const Eigen::Vector3d p = position.unaryExpr([](double x) { return snapped(x, kGrid); });
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    for (const double x : p) {
      write_float(bytes, x, kGrid);
    }
  }
  return add_accessor(document, positions, offset, shape.positions.size(),
                      {{"componentType", kFloat},
                       {"type", "VEC3"},
                       {"min", {low.x(), low.y(), low.z()}},
                       {"max", {high.x(), high.y(), high.z()}}});
}

int write_normals(Document& document, const Shape& shape) {
  std::string& bytes = document.views[normals];
  const std::size_t offset = bytes.size();
  for (const Eigen::Vector3d& normal : shape.normals) {
    for (const double x : normal) {
      write_float(bytes, x, kUnitGrid);
    }
  }
  return add_accessor(document, normals, offset, shape.normals.size(),
                      {{"componentType", kFloat}, {"type", "VEC3"}});
}

int write_texcoords(Document& document, const Shape& shape, const Eigen::Vector2d& tile) {
  std::string& bytes = document.views[texcoords];
  const std::size_t offset = bytes.size();
  for (const Eigen::Vector2d& texcoord : shape.texcoords) {
    write_float(bytes, texcoord.x() / tile.x(), kGrid);
    write_float(bytes, texcoord.y() / tile.y(), kGrid);
  }
  return add_accessor(document, texcoords, offset, shape.texcoords.size(),
                      {{"componentType", kFloat}, {"type", "VEC2"}});
}

int write_colors(Document& document, const Shape& shape) {
  std::string& bytes = document.views[colors];
  const std::size_t offset = bytes.size();
  for (const Color& color : shape.colors) {
    for (const double c : {color.x(), color.y(), color.z(), 1.0}) {
      bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(std::floor(c * 255 + 0.5))));
    }
  }
  return add_accessor(document, colors, offset, shape.colors.size(),
                      {{"componentType", kUnsignedByte}, {"normalized", true}, {"type", "VEC4"}});
}

int write_indices(Document& document, const Shape& shape) {
  vo::require(shape.positions.size() < 65535, "a mesh part has ", shape.positions.size(),
              " vertices, expected fewer than 65535");
  std::string& bytes = document.views[indices];
  const std::size_t offset = bytes.size();
  for (const std::array<int, 3>& triangle : shape.triangles) {
    for (const int index : triangle) {
      write_little_endian(bytes, static_cast<std::uint16_t>(index));
    }
  }
  return add_accessor(document, indices, offset, 3 * shape.triangles.size(),
                      {{"componentType", kUnsignedShort}, {"type", "SCALAR"}});
}

Json primitive(Document& document, const MeshPart& part, const std::vector<Material>& materials) {
  const auto finish = static_cast<std::size_t>(part.finish);
  Json attributes;
  attributes["POSITION"] = write_positions(document, part.shape);
  attributes["NORMAL"] = write_normals(document, part.shape);
  if (!materials.at(finish).image.empty()) {
    attributes["TEXCOORD_0"] = write_texcoords(document, part.shape, materials.at(finish).tile);
  }
  if (!part.shape.colors.empty()) {
    attributes["COLOR_0"] = write_colors(document, part.shape);
  }
  return {{"attributes", attributes},
          {"indices", write_indices(document, part.shape)},
          {"material", finish}};
}

void write_meshes(Document& document, const Model& model, const std::vector<Material>& materials) {
  for (const Mesh& mesh : model.meshes) {
    Json primitives;
    for (const MeshPart& part : mesh.parts) {
      primitives.push_back(primitive(document, part, materials));
    }
    document.json["meshes"].push_back({{"name", mesh.name}, {"primitives", primitives}});
  }
}

Json json_node(const Node& node) {
  Json json = {{"name", node.name}};
  const auto list = [](const auto& values) {
    Json numbers;
    for (const double value : values) {
      numbers.push_back(snapped(value, 1e6));
    }
    return numbers;
  };
  const Eigen::Quaterniond rotation(node.T_parent_node.linear());
  if (!node.T_parent_node.translation().isZero()) {
    json["translation"] = list(Eigen::Vector3d(node.T_parent_node.translation()));
  }
  if (std::abs(rotation.w()) < 1) {
    json["rotation"] = list(rotation.coeffs());  // x, y, z, w, as in glTF
  }
  if (node.scale != 1) {
    json["scale"] = {node.scale, node.scale, node.scale};
  }
  if (node.mesh != kNone) {
    json["mesh"] = node.mesh;
  }
  if (node.light != kNone) {
    json["extensions"]["KHR_lights_punctual"]["light"] = node.light;
  }
  if (!node.children.empty()) {
    json["children"] = node.children;
  }
  return json;
}

Json json_light(const Light& light) {
  return {{"name", light.name},
          {"type", light.kind == LightKind::point ? "point" : "directional"},
          {"color", {light.color.x(), light.color.y(), light.color.z()}},
          {"intensity", light.intensity}};
}

std::string join_views(Document& document) {
  constexpr std::array<int, view_count> kStrides = {12, 12, 8, 4, 0};
  std::string binary;
  for (std::size_t view = 0; view < view_count; ++view) {
    binary.resize((binary.size() + 3) / 4 * 4);
    Json json = {{"buffer", 0},
                 {"byteOffset", binary.size()},
                 {"byteLength", document.views.at(view).size()}};
    if (view != indices) {
      json["byteStride"] = kStrides.at(view);
    }
    json["target"] = view == indices ? 34963 : 34962;
    document.json["bufferViews"].push_back(json);
    binary += document.views.at(view);
  }
  return binary;
}

Json header(const Model& model) {
  Json json;
  json["asset"] = {{"version", "2.0"}, {"generator", "edvo make_room"}, {"copyright", "MIT"}};
  json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_unlit"};
  for (const Light& light : model.lights) {
    json["extensions"]["KHR_lights_punctual"]["lights"].push_back(json_light(light));
  }
  json["scene"] = 0;
  json["scenes"].push_back({{"name", "room"}, {"nodes", model.roots}});
  for (const Node& node : model.nodes) {
    json["nodes"].push_back(json_node(node));
  }
  return json;
}

}  // namespace

void write_gltf(const Model& model, const std::vector<Material>& materials,
                const std::vector<NamedImage>& images, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  vo::require(!error, folder.string(), ": cannot be made: ", error.message());
  Document document = {header(model), {}};
  write_meshes(document, model, materials);
  add_materials(document.json, materials, images);
  const std::string binary = join_views(document);
  document.json["buffers"].push_back({{"uri", "room.bin"}, {"byteLength", binary.size()}});
  vo::write_file(folder / "room.bin", binary, vo::ExistingOutput::replace);
  vo::write_file(folder / "room.gltf", json_text(document.json), vo::ExistingOutput::replace);
  for (const NamedImage& image : images) {
    vo::write_file(folder / (image.name + ".png"), vo::encode_png(image.pixels),
                   vo::ExistingOutput::replace);
  }
}

}  // namespace room
