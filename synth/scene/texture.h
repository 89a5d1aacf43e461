#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "synth/scene/scene.h"

namespace synth {

/// Returns the image with all its mip levels. Each level is the area average of the next finer one
/// in linear values, whatever the encoding; odd sizes are halved rounding down, as in OpenGL.
TextureImage build_mip_levels(const cv::Mat_<cv::Vec4b>& image,
                              TexelEncoding encoding = TexelEncoding::srgb);

/// Returns the filtered linear RGBA value at glTF texture coordinates: texel (i, j) has its centre
/// at ((i + 0.5) / width, (j + 0.5) / height). `lod` is the binary logarithm of the number of
/// texels of level 0 along an edge of one sample; at or below 0 the texture is magnified.
Eigen::Vector4f sample(const TextureImage& image, const Texture& texture, const Eigen::Vector2f& uv,
                       float lod);

}  // namespace synth
