#include "tools/make_scenes/gltf_writing/gltf_materials.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "vo/core/error.h"

namespace scenes {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the index of `value` in the array `gltf[key]`; appends it unless it is there.
std::size_t index_of(Json& gltf, const std::string& key, const Json& value) {
  Json& array = gltf[key];
  const auto found = std::find(array.begin(), array.end(), value);
  if (found != array.end()) {
    return static_cast<std::size_t>(found - array.begin());
  }
  array.push_back(value);
  return array.size() - 1;
}

std::size_t image_index(const std::vector<NamedImage>& images, const std::string& name) {
  const auto image = std::find_if(images.begin(), images.end(), [&](const NamedImage& candidate) {
    return candidate.name == name;
  });
  vo::require(image != images.end(), "no image is called ", name);
  return static_cast<std::size_t>(image - images.begin());
}

Json json_sampler(const Sampler& sampler) {
  return {{"magFilter", static_cast<int>(sampler.magnification)},
          {"minFilter", static_cast<int>(sampler.minification)},
          {"wrapS", static_cast<int>(sampler.wrap)},
          {"wrapT", static_cast<int>(sampler.wrap)}};
}

Json json_material(const Material& material) {
  const Color& color = material.color;
  Json json = {{"name", material.name},
               {"pbrMetallicRoughness",
                {{"baseColorFactor", {color.x(), color.y(), color.z(), 1.0}},
                 {"metallicFactor", material.metallic},
                 {"roughnessFactor", material.roughness}}}};
  if (!material.emission.isZero()) {
    const double strength = std::max(material.emission.maxCoeff(), 1.0);
    const Color factor = material.emission / strength;
    json["emissiveFactor"] = {factor.x(), factor.y(), factor.z()};
    if (strength > 1) {
      json["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
    }
  }
  if (material.double_sided) {
    json["doubleSided"] = true;
  }
  if (material.unlit) {
    json["extensions"]["KHR_materials_unlit"] = Json::object();
  }
  if (material.transmission > 0) {
    json["extensions"]["KHR_materials_transmission"] = {
        {"transmissionFactor", material.transmission}};
  }
  return json;
}

}  // namespace

void add_materials(Json& gltf, const std::vector<Material>& materials,
                   const std::vector<NamedImage>& images) {
  for (const Material& material : materials) {
    Json json = json_material(material);
    if (!material.image.empty()) {
      const Json texture = {{"sampler", index_of(gltf, "samplers", json_sampler(material.sampler))},
                            {"source", image_index(images, material.image)}};
      json["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
          index_of(gltf, "textures", texture);
    }
    gltf["materials"].push_back(json);
  }
  for (const NamedImage& image : images) {
    gltf["images"].push_back({{"name", image.name}, {"uri", image.name + ".png"}});
  }
}

}  // namespace scenes
