#include "synth/gltf_materials/texture_reader.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "synth/gltf_document/notes.h"
#include "synth/gltf_model/image.h"
#include "synth/scene/texture.h"

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

}  // namespace

TextureReader::TextureReader(GltfReading& reading, Scene& scene, NeededTextures needed)
    : reading_(reading), model_(reading.model), scene_(scene), needed_(needed) {}

TextureSlot TextureReader::slot(const TextureReference& info, TexelEncoding encoding,
                                NeededTextures use) {
  TextureSlot slot;
  slot.texcoord_set = info.texcoord_set;
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
bool TextureReader::is_left_out(int gltf_image, NeededTextures use) {
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

int TextureReader::texture(int gltf_index, TexelEncoding encoding, NeededTextures use) {
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

int TextureReader::image(int gltf_index, TexelEncoding encoding) {
  const auto [entry, is_new] = images_.try_emplace({gltf_index, encoding});
  if (is_new) {
    const std::string place = model_.image_place(gltf_index);
    const Bytes encoded = read_encoded_image(model_, gltf_index);
    image_budget_.take(texels_in(encoded, place) / 3 * 4 * sizeof(cv::Vec4b), place);
    const cv::Mat_<cv::Vec4b> image = decode_image(encoded, place);
    entry->second = static_cast<int>(scene_.images.size());
    scene_.images.push_back(build_mip_levels(image, encoding));
  }
  return entry->second;
}

}  // namespace synth
