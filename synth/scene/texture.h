#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/scene/scene.h"

namespace synth {

/// The image with all its mip levels. Each level is the area average of the one before, of what the
/// encoding says is linear; odd sizes are halved downwards, as GL does.
TextureImage build_mip_levels(const cv::Mat_<cv::Vec4b>& image,
                              TexelEncoding encoding = TexelEncoding::srgb);

/// The linear RGBA value at glTF texture coordinates: texel (i, j) has its centre at
/// ((i + 0.5) / width, (j + 0.5) / height). `lod` is the binary logarithm of the texels of level 0
/// that one sample covers along an edge; at or below 0 the texture is magnified.
Eigen::Vector4f sample(const TextureImage& image, const Texture& texture, const Eigen::Vector2f& uv,
                       float lod);

}  // namespace synth
