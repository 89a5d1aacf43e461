#include "synth/gltf_material.h"

#include <cmath>
#include <cstddef>
#include <string>

#include "synth/gltf_image.h"
#include "synth/gltf_notes.h"
#include "synth/texture.h"

namespace synth {
namespace {

/// A lod above that of any image, whose last level is its mean.
constexpr float kMeanLod = 64;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

Eigen::Vector2f read_pair(const tinygltf::Value& object, const std::string& key,
                          const Eigen::Vector2f& absent) {
  if (!object.Has(key)) {
    return absent;
  }
  const tinygltf::Value& pair = object.Get(key);
  return Eigen::Vector2d(pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble())
      .cast<float>();
}

/// KHR_texture_transform: scales, rotates against the clock of the image (whose v points down),
/// and moves, in this order.
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

}  // namespace

TexcoordMapping texcoord_mapping(const GltfModel& model, int material) {
  TexcoordMapping mapping;
  if (material == kNone) {
    return mapping;
  }
  const tinygltf::TextureInfo& info =
      model.content.materials[at(material)].pbrMetallicRoughness.baseColorTexture;
  mapping.set = info.texCoord;
  const auto transform = info.extensions.find("KHR_texture_transform");
  if (transform != info.extensions.end()) {
    mapping.T_image_texcoord = read_texture_transform(transform->second);
    if (transform->second.Has("texCoord")) {
      mapping.set = transform->second.Get("texCoord").GetNumberAsInt();
    }
  }
  return mapping;
}

MaterialReader::MaterialReader(const GltfModel& model, Scene& scene, Notes& notes)
    : model_(model),
      scene_(scene),
      notes_(notes),
      materials_(model.content.materials.size(), kNone),
      textures_(model.content.textures.size(), kNone),
      images_(model.content.images.size(), kNone) {}

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

Material MaterialReader::read_material(const tinygltf::Material& source) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  Material material;
  material.base_color = Eigen::Map<const Eigen::Vector4d>(pbr.baseColorFactor.data()).cast<float>();
  material.base_color_texture = texture(pbr.baseColorTexture.index);
  material.unlit = source.extensions.count("KHR_materials_unlit") > 0;
  if (!material.unlit) {
    material.emission = read_emission(source);
  }
  note_what_is_left_out(source);
  return material;
}

/// The factor times its strength times the mean of the texture, which the scene has no place for.
Eigen::Vector3f MaterialReader::read_emission(const tinygltf::Material& source) {
  Eigen::Vector3f emission =
      Eigen::Map<const Eigen::Vector3d>(source.emissiveFactor.data()).cast<float>();
  const auto extension = source.extensions.find("KHR_materials_emissive_strength");
  if (extension != source.extensions.end() && extension->second.Has("emissiveStrength")) {
    emission *= static_cast<float>(extension->second.Get("emissiveStrength").GetNumberAsDouble());
  }
  if (emission.isZero(0) || source.emissiveTexture.index == kNone) {
    return emission;
  }
  const int map = texture(source.emissiveTexture.index);
  if (map != kNone) {
    add_note(notes_, "emissive textures are replaced by their mean colour");
    const TextureImage& image = scene_.images[at(scene_.textures[at(map)].image)];
    emission.array() *=
        sample(image, Texture{}, Eigen::Vector2f::Zero(), kMeanLod).head<3>().array();
  }
  return emission;
}

int MaterialReader::texture(int gltf_index) {
  if (gltf_index == kNone) {
    return kNone;
  }
  const tinygltf::Texture& source = model_.content.textures[at(gltf_index)];
  if (source.source == kNone) {
    add_note(notes_, "textures without PNG or JPEG image are left out");
    return kNone;
  }
  int& index = textures_[at(gltf_index)];
  if (index == kNone) {
    Texture texture;
    if (source.sampler != kNone) {
      texture = read_sampler(model_.content.samplers[at(source.sampler)]);
    }
    texture.image = image(source.source);
    index = static_cast<int>(scene_.textures.size());
    scene_.textures.push_back(texture);
  }
  return index;
}

int MaterialReader::image(int gltf_index) {
  int& index = images_[at(gltf_index)];
  if (index == kNone) {
    const std::string place = model_.place("images", gltf_index);
    const cv::Mat_<cv::Vec4b> image = decode_image(read_encoded_image(model_, gltf_index), place);
    index = static_cast<int>(scene_.images.size());
    scene_.images.push_back(build_mip_levels(image));
  }
  return index;
}

void MaterialReader::note_what_is_left_out(const tinygltf::Material& source) {
  if (source.alphaMode == "BLEND" || source.alphaMode == "MASK") {
    add_note(notes_, "materials of alphaMode " + source.alphaMode + " are taken as opaque");
  }
  if (source.normalTexture.index != kNone || source.occlusionTexture.index != kNone ||
      source.pbrMetallicRoughness.metallicRoughnessTexture.index != kNone) {
    add_note(notes_, "normal, occlusion and metallic-roughness textures are left out");
  }
}

}  // namespace synth
