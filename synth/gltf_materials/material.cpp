#include "synth/gltf_materials/material.h"

#include <algorithm>
#include <string>

#include "synth/gltf_document/notes.h"

namespace synth {
namespace {

AlphaMode read_alpha_mode(const std::string& name) {
  return name == "MASK" ? AlphaMode::mask : name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

/// An extension of a material, which may be absent.
class MaterialExtension {
 public:
  MaterialExtension(const tinygltf::Material& source, const char* name) {
    const auto extension = source.extensions.find(name);
    extension_ = extension != source.extensions.end() ? &extension->second : nullptr;
  }

  float number(const char* key, float absent) const {
    const tinygltf::Value* const value = member(key);
    return value != nullptr ? static_cast<float>(value->GetNumberAsDouble()) : absent;
  }

  Eigen::Vector3f color(const char* key) const {
    Eigen::Vector3f color = Eigen::Vector3f::Ones();
    if (const tinygltf::Value* const value = member(key)) {
      for (int i = 0; i < 3; ++i) {
        color[i] = static_cast<float>(value->Get(i).GetNumberAsDouble());
      }
    }
    return color;
  }

  tinygltf::NormalTextureInfo texture(const char* key) const {
    tinygltf::NormalTextureInfo info;
    const tinygltf::Value* const value = member(key);
    if (value == nullptr) {
      return info;
    }
    info.index = value->Get("index").GetNumberAsInt();
    info.texCoord = value->Has("texCoord") ? value->Get("texCoord").GetNumberAsInt() : 0;
    info.scale = value->Has("scale") ? value->Get("scale").GetNumberAsDouble() : 1;
    if (value->Has("extensions")) {
      const tinygltf::Value& extensions = value->Get("extensions");
      for (const std::string& name : extensions.Keys()) {
        info.extensions[name] = extensions.Get(name);
      }
    }
    return info;
  }

 private:
  const tinygltf::Value* member(const char* key) const {
    return extension_ != nullptr && extension_->Has(key) ? &extension_->Get(key) : nullptr;
  }

  const tinygltf::Value* extension_;
};

/// Reads KHR_materials_volume, whose lengths are times `scale`. How thick a body is, its mesh says;
/// the extension's texture of thicknesses is for renderers that follow no rays.
void read_volume(const tinygltf::Material& source, double scale, MaterialLayers& layers) {
  const MaterialExtension volume(source, "KHR_materials_volume");
  layers.is_solid = volume.number("thicknessFactor", 0) > 0;
  layers.attenuation_distance =
      static_cast<float>(scale) * volume.number("attenuationDistance", layers.attenuation_distance);
  layers.attenuation_color = volume.color("attenuationColor");
}

}  // namespace

Brightness emission_of(const tinygltf::Material& source) {
  const MaterialExtension strength(source, "KHR_materials_emissive_strength");
  return {Eigen::Map<const Eigen::Vector3d>(source.emissiveFactor.data()).cast<float>(),
          strength.number("emissiveStrength", 1)};
}

MaterialReader::MaterialReader(GltfReading& reading, Scene& scene, NeededTextures needed,
                               double scale)
    : reading_(reading),
      model_(reading.model),
      scene_(scene),
      scale_(scale),
      materials_(model_.content.materials.size(), kNone),
      textures_(reading, scene, needed) {}

int MaterialReader::material(int gltf_index) {
  if (gltf_index == kNone) {
    return kNone;
  }
  int& index = materials_[at(gltf_index)];
  if (index == kNone) {
    const Material material = read_material(model_.content.materials[at(gltf_index)]);
    index = static_cast<int>(scene_.materials.size());
    scene_.materials.push_back(material);
  }
  return index;
}

std::vector<int> MaterialReader::sources() const {
  std::vector<int> sources(scene_.materials.size(), kNone);
  for (std::size_t i = 0; i < materials_.size(); ++i) {
    if (materials_[i] != kNone) {
      sources[at(materials_[i])] = static_cast<int>(i);
    }
  }
  return sources;
}

Material MaterialReader::read_material(const tinygltf::Material& source) {
  Material material;
  material.name = source.name;
  if (source.alphaMode != "OPAQUE" && source.alphaMode != "MASK" && source.alphaMode != "BLEND") {
    add_note(reading_.notes, "materials of alphaMode " + source.alphaMode + " are opaque");
  }
  material.alpha_mode = read_alpha_mode(source.alphaMode);
  read_surface(source, material);
  material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
  material.double_sided = source.doubleSided;
  material.unlit = source.extensions.count("KHR_materials_unlit") > 0;
  if (!material.unlit) {
    read_maps(source, material);
    read_specular_maps(source, material);
    read_layers(source, material.layers);
  }
  return material;
}

void MaterialReader::read_surface(const tinygltf::Material& source, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const bool is_opaque = material.alpha_mode == AlphaMode::opaque;
  material.base_color = Eigen::Map<const Eigen::Vector4d>(pbr.baseColorFactor.data()).cast<float>();
  material.base_color_texture =
      textures_.slot(TextureReference::of(pbr.baseColorTexture), TexelEncoding::srgb,
                     is_opaque ? NeededTextures::base_color : NeededTextures::alpha);
  material.metallic = static_cast<float>(pbr.metallicFactor);
  material.roughness = static_cast<float>(pbr.roughnessFactor);
  const MaterialExtension specular(source, "KHR_materials_specular");
  material.specular = specular.number("specularFactor", 1);
  material.specular_color = specular.color("specularColorFactor");
  material.ior = MaterialExtension(source, "KHR_materials_ior").number("ior", material.ior);
}

/// Returns whether an animation may let a surface shine that does not shine at rest.
bool MaterialReader::may_begin_to_shine() const {
  const std::vector<tinygltf::Animation>& animations = model_.content.animations;
  return std::any_of(
      animations.begin(), animations.end(), [](const tinygltf::Animation& animation) {
        return std::any_of(
            animation.channels.begin(), animation.channels.end(),
            [](const tinygltf::AnimationChannel& c) { return c.target_path == "pointer"; });
      });
}

/// Returns the texture of a lit material.
template <typename TextureInfo>
TextureSlot MaterialReader::surface_map(const TextureInfo& info, TexelEncoding encoding) {
  return textures_.slot(TextureReference::of(info), encoding, NeededTextures::surfaces);
}

/// Reads what only a lit material has: emission and all textures but the base colour's.
void MaterialReader::read_maps(const tinygltf::Material& source, Material& material) {
  material.metallic_roughness_texture =
      surface_map(source.pbrMetallicRoughness.metallicRoughnessTexture, TexelEncoding::linear);
  material.normal_texture = surface_map(source.normalTexture, TexelEncoding::linear);
  material.normal_scale = static_cast<float>(source.normalTexture.scale);
  material.occlusion_texture = surface_map(source.occlusionTexture, TexelEncoding::linear);
  material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
  const Brightness emission = emission_of(source);
  material.emission = emission.strength * emission.color;
  if (!material.emission.isZero(0) || may_begin_to_shine()) {
    material.emissive_texture = surface_map(source.emissiveTexture, TexelEncoding::srgb);
  }
}

void MaterialReader::read_specular_maps(const tinygltf::Material& source, Material& material) {
  const MaterialExtension specular(source, "KHR_materials_specular");
  material.specular_texture =
      surface_map(specular.texture("specularTexture"), TexelEncoding::linear);
  material.specular_color_texture =
      surface_map(specular.texture("specularColorTexture"), TexelEncoding::srgb);
}

/// Reads KHR_materials_transmission, _volume and _clearcoat.
void MaterialReader::read_layers(const tinygltf::Material& source, MaterialLayers& layers) {
  const MaterialExtension transmission(source, "KHR_materials_transmission");
  layers.transmission = transmission.number("transmissionFactor", 0);
  layers.transmission_texture =
      surface_map(transmission.texture("transmissionTexture"), TexelEncoding::linear);
  read_volume(source, scale_, layers);
  const MaterialExtension coat(source, "KHR_materials_clearcoat");
  layers.clearcoat = coat.number("clearcoatFactor", 0);
  layers.clearcoat_texture = surface_map(coat.texture("clearcoatTexture"), TexelEncoding::linear);
  layers.clearcoat_roughness = coat.number("clearcoatRoughnessFactor", 0);
  layers.clearcoat_roughness_texture =
      surface_map(coat.texture("clearcoatRoughnessTexture"), TexelEncoding::linear);
  const tinygltf::NormalTextureInfo normal = coat.texture("clearcoatNormalTexture");
  layers.clearcoat_normal_texture = surface_map(normal, TexelEncoding::linear);
  layers.clearcoat_normal_scale = static_cast<float>(normal.scale);
}

}  // namespace synth
