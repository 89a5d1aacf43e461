#pragma once

#include <opencv2/core.hpp>

#include "synth/scene/scene.h"
#include "synth/scene/texture.h"

namespace synth {

/// Adds a texture of linear texels, RGBA, that shows each without its neighbours.
inline TextureSlot add_texels(Scene& scene, const cv::Mat_<cv::Vec4b>& texels) {
  TextureSlot slot;
  slot.texture = static_cast<int>(scene.textures.size());
  scene.textures.push_back({.image = static_cast<int>(scene.images.size()),
                            .magnification = TexelFilter::nearest,
                            .minification = TexelFilter::nearest,
                            .mip = MipFilter::none});
  scene.images.push_back(build_mip_levels(texels, TexelEncoding::linear));
  return slot;
}

/// Adds a texture of one linear colour.
inline TextureSlot plain_texture(Scene& scene, const cv::Vec4b& texel, int texcoord_set = 0) {
  TextureSlot slot = add_texels(scene, cv::Mat_<cv::Vec4b>(1, 1, texel));
  slot.texcoord_set = texcoord_set;
  return slot;
}

}  // namespace synth
