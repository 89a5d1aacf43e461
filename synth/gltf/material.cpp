#include "synth/gltf/material.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "synth/gltf_document/notes.h"
#include "synth/gltf_model/image.h"
#include "synth/scene/texture.h"
#include "vo/core/error.h"

namespace synth {
namespace {

Eigen::Vector2f read_pair(const tinygltf::Value& object, const std::string& key,
                          const Eigen::Vector2f& absent) {
  if (!object.Has(key)) {
    return absent;
  }
  const tinygltf::Value& pair = object.Get(key);
  return Eigen::Vector2d(pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble())
      .cast<float>();
}

/// Reads KHR_texture_transform, which scales, rotates counter-clockwise in the image (whose v
/// points down) and translates, in this order.
Eigen::Affine2f read_texture_transform(const tinygltf::Value& extension) {
  const double angle =
      extension.Has("rotation") ? extension.Get("rotation").GetNumberAsDouble() : 0.0;  // rad
  const auto sine = static_cast<float>(std::sin(angle));
  const auto cosine = static_cast<float>(std::cos(angle));
  Eigen::Matrix2f rotation;
  rotation << cosine, sine, -sine, cosine;
  const Eigen::Vector2f scale = read_pair(extension, "scale", Eigen::Vector2f::Ones());
  Eigen::Affine2f T_image_texcoord;
  T_image_texcoord.setIdentity();
  T_image_texcoord.linear() = rotation * scale.asDiagonal();
  T_image_texcoord.translation() = read_pair(extension, "offset", Eigen::Vector2f::Zero());
  return T_image_texcoord;
}

Wrap read_wrap(int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::clamp_to_edge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::mirrored_repeat;
    default:
      return Wrap::repeat;
  }
}

void read_minification(int filter, Texture& texture) {
  const bool is_nearest = filter == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                          filter == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                          filter == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
  texture.minification = is_nearest ? TexelFilter::nearest : TexelFilter::linear;
  switch (filter) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
      texture.mip = MipFilter::none;
      break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
      texture.mip = MipFilter::nearest;
      break;
    default:
      texture.mip = MipFilter::linear;
      break;
  }
}

Texture read_sampler(const tinygltf::Sampler& sampler) {
  Texture texture;
  texture.wrap_u = read_wrap(sampler.wrapS);
  texture.wrap_v = read_wrap(sampler.wrapT);
  texture.magnification = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST
                              ? TexelFilter::nearest
                              : TexelFilter::linear;
  read_minification(sampler.minFilter, texture);
  return texture;
}

AlphaMode read_alpha_mode(const std::string& name) {
  return name == "MASK" ? AlphaMode::mask : name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

/// The members of material extensions that are not read although the extension is.
constexpr std::array<std::pair<const char*, const char*>, 8> kLeftOut = {
    {{"KHR_materials_specular", "specularTexture"},
     {"KHR_materials_specular", "specularColorFactor"},
     {"KHR_materials_specular", "specularColorTexture"},
     {"KHR_materials_transmission", "transmissionTexture"},
     {"KHR_materials_volume", "thicknessTexture"},
     {"KHR_materials_clearcoat", "clearcoatTexture"},
     {"KHR_materials_clearcoat", "clearcoatRoughnessTexture"},
     {"KHR_materials_clearcoat", "clearcoatNormalTexture"}}};

/// Returns a member of a material's extension, null without it.
const tinygltf::Value* member_of(const tinygltf::Material& source, const char* name,
                                 const char* member) {
  const auto extension = source.extensions.find(name);
  return extension != source.extensions.end() && extension->second.Has(member)
             ? &extension->second.Get(member)
             : nullptr;
}

void note_what_is_left_out(const tinygltf::Material& source, Notes& notes) {
  for (const auto& [name, member] : kLeftOut) {
    if (member_of(source, name, member) != nullptr) {
      add_note(notes, vo::concat(member, " of ", name, " is left out"));
    }
  }
}

/// Returns a number of a material's extension, `absent` without it.
float number_of(const tinygltf::Material& source, const char* name, const char* member,
                float absent) {
  const tinygltf::Value* const value = member_of(source, name, member);
  return value != nullptr ? static_cast<float>(value->GetNumberAsDouble()) : absent;
}

/// Returns the emissive factor times the emissive strength.
Eigen::Vector3f read_emission(const tinygltf::Material& source) {
  const Eigen::Vector3f factor =
      Eigen::Map<const Eigen::Vector3d>(source.emissiveFactor.data()).cast<float>();
  return number_of(source, "KHR_materials_emissive_strength", "emissiveStrength", 1) * factor;
}

/// Returns a material's layers; their lengths are times `scale`.
MaterialLayers read_layers(const tinygltf::Material& source, double scale) {
  MaterialLayers layers;
  layers.transmission = number_of(source, "KHR_materials_transmission", "transmissionFactor", 0);
  layers.clearcoat = number_of(source, "KHR_materials_clearcoat", "clearcoatFactor", 0);
  layers.clearcoat_roughness =
      number_of(source, "KHR_materials_clearcoat", "clearcoatRoughnessFactor", 0);
  constexpr const char* kVolume = "KHR_materials_volume";
  layers.is_solid = number_of(source, kVolume, "thicknessFactor", 0) > 0;
  layers.attenuation_distance =
      static_cast<float>(scale) *
      number_of(source, kVolume, "attenuationDistance", layers.attenuation_distance);
  if (const tinygltf::Value* const color = member_of(source, kVolume, "attenuationColor")) {
    for (int i = 0; i < 3; ++i) {
      layers.attenuation_color[i] = static_cast<float>(color->Get(i).GetNumberAsDouble());
    }
  }
  return layers;
}

}  // namespace

MaterialReader::MaterialReader(GltfReading& reading, Scene& scene, const GltfOptions& options)
    : reading_(reading),
      model_(reading.model),
      scene_(scene),
      needed_(options.needed),
      scale_(options.scale),
      materials_(model_.content.materials.size(), kNone) {}

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
    material.layers = read_layers(source, scale_);
  }
  return material;
}

void MaterialReader::read_surface(const tinygltf::Material& source, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  const bool is_opaque = material.alpha_mode == AlphaMode::opaque;
  material.base_color = Eigen::Map<const Eigen::Vector4d>(pbr.baseColorFactor.data()).cast<float>();
  material.base_color_texture =
      slot(pbr.baseColorTexture, TexelEncoding::srgb,
           is_opaque ? NeededTextures::base_color : NeededTextures::alpha);
  material.metallic = static_cast<float>(pbr.metallicFactor);
  material.roughness = static_cast<float>(pbr.roughnessFactor);
  material.specular = number_of(source, "KHR_materials_specular", "specularFactor", 1);
  material.ior = number_of(source, "KHR_materials_ior", "ior", material.ior);
  note_what_is_left_out(source, reading_.notes);
}

/// Reads what only a lit material has: emission and all textures but the base colour's.
void MaterialReader::read_maps(const tinygltf::Material& source, Material& material) {
  material.metallic_roughness_texture = slot(source.pbrMetallicRoughness.metallicRoughnessTexture,
                                             TexelEncoding::linear, NeededTextures::surfaces);
  material.normal_texture =
      slot(source.normalTexture, TexelEncoding::linear, NeededTextures::surfaces);
  material.normal_scale = static_cast<float>(source.normalTexture.scale);
  material.occlusion_texture =
      slot(source.occlusionTexture, TexelEncoding::linear, NeededTextures::surfaces);
  material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
  material.emission = read_emission(source);
  if (!material.emission.isZero(0)) {
    material.emissive_texture =
        slot(source.emissiveTexture, TexelEncoding::srgb, NeededTextures::surfaces);
  }
}

template <typename TextureInfo>
TextureSlot MaterialReader::slot(const TextureInfo& info, TexelEncoding encoding,
                                 NeededTextures use) {
  TextureSlot slot;
  slot.texcoord_set = info.texCoord;
  const auto transform = info.extensions.find("KHR_texture_transform");
  if (transform != info.extensions.end()) {
    slot.T_image_texcoord = read_texture_transform(transform->second);
    if (transform->second.Has("texCoord")) {
      slot.texcoord_set = transform->second.Get("texCoord").GetNumberAsInt();
    }
  }
  if (slot.texcoord_set >= kTexcoordSets) {
    add_note(reading_.notes,
             "textures that use texture coordinates beyond TEXCOORD_1 are left out");
    return {};
  }
  slot.texture = texture(info.index, encoding, use);
  return slot;
}

/// Returns whether an image's file does not exist, and notes it. Throws vo::Error if textures of
/// this use are needed.
bool MaterialReader::is_left_out(int gltf_image, NeededTextures use) {
  const auto missing = model_.missing_images.find(gltf_image);
  if (missing == model_.missing_images.end()) {
    return false;
  }
  if (needed_ <= use) {
    fail_for_missing_images(model_);
  }
  add_note(reading_.notes, missing->second.element + ": " + missing->second.path.string() +
                               " does not exist and is left out, as nothing here needs it");
  return true;
}

int MaterialReader::texture(int gltf_index, TexelEncoding encoding, NeededTextures use) {
  if (gltf_index == kNone) {
    return kNone;
  }
  const tinygltf::Texture& source = model_.content.textures[at(gltf_index)];
  if (source.source == kNone) {
    add_note(reading_.notes, "textures without PNG or JPEG image are left out");
    return kNone;
  }
  if (is_left_out(source.source, use)) {
    return kNone;
  }
  const auto [entry, is_new] = textures_.try_emplace({gltf_index, encoding});
  if (is_new) {
    Texture texture;
    if (source.sampler != kNone) {
      texture = read_sampler(model_.content.samplers[at(source.sampler)]);
    }
    texture.image = image(source.source, encoding);
    entry->second = static_cast<int>(scene_.textures.size());
    scene_.textures.push_back(texture);
  }
  return entry->second;
}

int MaterialReader::image(int gltf_index, TexelEncoding encoding) {
  const auto [entry, is_new] = images_.try_emplace({gltf_index, encoding});
  if (is_new) {
    const std::string place = model_.place("images", gltf_index);
    const Bytes encoded = read_encoded_image(model_, gltf_index);
    image_budget_.take(texels_in(encoded, place) / 3 * 4 * sizeof(cv::Vec4b), place);
    const cv::Mat_<cv::Vec4b> image = decode_image(encoded, place);
    entry->second = static_cast<int>(scene_.images.size());
    scene_.images.push_back(build_mip_levels(image, encoding));
  }
  return entry->second;
}

}  // namespace synth
