#include "tools/make_scenes/gltf_writing/gltf_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "tools/make_scenes/gltf_writing/gltf_animations.h"
#include "tools/make_scenes/gltf_writing/gltf_document.h"
#include "tools/make_scenes/gltf_writing/gltf_materials.h"
#include "tools/make_scenes/gltf_writing/gltf_skins.h"
#include "tools/make_scenes/gltf_writing/json_text.h"
#include "vo/core/error.h"
#include "vo/files/output.h"
#include "vo/image_files/png.h"

namespace scenes {
namespace {

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
  const auto place =
      std::lower_bound(document.finishes.begin(), document.finishes.end(), part.finish);
  const auto material = static_cast<std::size_t>(place - document.finishes.begin());
  Json attributes;
  attributes["POSITION"] = write_positions(document, part.shape);
  attributes["NORMAL"] = write_normals(document, part.shape);
  if (!materials.at(material).image.empty()) {
    attributes["TEXCOORD_0"] = write_texcoords(document, part.shape, materials.at(material).tile);
  }
  if (!part.shape.colors.empty()) {
    attributes["COLOR_0"] = write_colors(document, part.shape);
  }
  if (!part.shape.joints.empty()) {
    add_joints(document, part.shape, attributes);
  }
  return {{"attributes", attributes},
          {"indices", write_indices(document, part.shape)},
          {"material", material}};
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
      numbers.push_back(snapped(value, kFineGrid));
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
  if (node.skin != kNone) {
    json["skin"] = node.skin;
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

void name_extensions(Json& json, const Model& model, const std::vector<Material>& materials) {
  Json used = Json::array();
  if (!model.lights.empty()) {
    used.push_back("KHR_lights_punctual");
  }
  const auto any = [&](auto has) { return std::any_of(materials.begin(), materials.end(), has); };
  if (any([](const Material& material) { return material.unlit; })) {
    used.push_back("KHR_materials_unlit");
  }
  if (any([](const Material& material) { return material.emission.maxCoeff() > 1; })) {
    used.push_back("KHR_materials_emissive_strength");
  }
  if (any([](const Material& material) { return material.transmission > 0; })) {
    used.push_back("KHR_materials_transmission");
  }
  if (!used.empty()) {
    json["extensionsUsed"] = used;
  }
}

Json header(const Model& model, const std::vector<Material>& materials) {
  Json json;
  json["asset"] = {
      {"version", "2.0"}, {"generator", "edvo make_" + model.name}, {"copyright", "MIT"}};
  name_extensions(json, model, materials);
  for (const Light& light : model.lights) {
    json["extensions"]["KHR_lights_punctual"]["lights"].push_back(json_light(light));
  }
  json["scene"] = 0;
  json["scenes"].push_back({{"name", model.name}, {"nodes", model.roots}});
  for (const Node& node : model.nodes) {
    json["nodes"].push_back(json_node(node));
  }
  return json;
}

/// Returns the finishes that the model shows, in enumerator order.
std::vector<Finish> finishes_of(const Model& model) {
  std::set<Finish> finishes;
  for (const Mesh& mesh : model.meshes) {
    for (const MeshPart& part : mesh.parts) {
      finishes.insert(part.finish);
    }
  }
  return {finishes.begin(), finishes.end()};
}

std::vector<Material> chosen_materials(const std::vector<Finish>& finishes) {
  const std::vector<Material> all = materials();
  std::vector<Material> chosen;
  for (const Finish finish : finishes) {
    chosen.push_back(all.at(static_cast<std::size_t>(finish)));
  }
  return chosen;
}

std::vector<NamedImage> chosen_images(const std::vector<Material>& materials) {
  std::vector<NamedImage> chosen;
  for (const NamedImage& image : images()) {
    if (std::any_of(materials.begin(), materials.end(),
                    [&](const Material& material) { return material.image == image.name; })) {
      chosen.push_back(image);
    }
  }
  return chosen;
}

}  // namespace

void write_gltf(const Model& model, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  vo::require(!error, folder.string(), ": cannot be made: ", error.message());
  const std::vector<Finish> finishes = finishes_of(model);
  const std::vector<Material> materials = chosen_materials(finishes);
  Document document = {header(model, materials), finishes, {}};
  const std::vector<NamedImage> images = chosen_images(materials);
  write_meshes(document, model, materials);
  add_animations(document, model);
  add_skins(document, model);
  add_materials(document.json, materials, images);
  const std::string binary = join_views(document);
  document.json["buffers"].push_back({{"uri", model.name + ".bin"}, {"byteLength", binary.size()}});
  vo::write_file(folder / (model.name + ".bin"), binary, vo::ExistingOutput::replace);
  vo::write_file(folder / (model.name + ".gltf"), json_text(document.json),
                 vo::ExistingOutput::replace);
  for (const NamedImage& image : images) {
    vo::write_file(folder / (image.name + ".png"), vo::encode_png(image.paint()),
                   vo::ExistingOutput::replace);
  }
}

}  // namespace scenes
