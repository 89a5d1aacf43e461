#include "synth/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <opencv2/imgproc.hpp>

#include "synth/srgb.h"

namespace synth {
namespace {

cv::Mat_<cv::Vec4f> decode_image(const cv::Mat_<cv::Vec4b>& image) {
  cv::Mat_<cv::Vec4f> linear(image.size());
  std::transform(image.begin(), image.end(), linear.begin(), [](const cv::Vec4b& texel) {
    return cv::Vec4f(decode_srgb_8bit(texel[0]), decode_srgb_8bit(texel[1]),
                     decode_srgb_8bit(texel[2]), static_cast<float>(texel[3]) / 255.0F);
  });
  return linear;
}

cv::Mat_<cv::Vec4b> encode_image(const cv::Mat_<cv::Vec4f>& linear) {
  cv::Mat_<cv::Vec4b> image(linear.size());
  std::transform(linear.begin(), linear.end(), image.begin(), [](const cv::Vec4f& texel) {
    return cv::Vec4b(encode_srgb_8bit(texel[0]), encode_srgb_8bit(texel[1]),
                     encode_srgb_8bit(texel[2]),
                     cv::saturate_cast<std::uint8_t>(texel[3] * 255.0F));
  });
  return image;
}

/// Brings a coordinate into [0, 1]. What is not a number becomes 0.
inline float fold(float coordinate, Wrap wrap) {
  if (coordinate >= 0 && coordinate <= 1) {
    return coordinate;
  }
  switch (wrap) {
    case Wrap::repeat:
      coordinate -= std::floor(coordinate);
      break;
    case Wrap::mirrored_repeat:
      coordinate = std::abs(coordinate - 2.0F * std::floor(0.5F * coordinate + 0.5F));
      break;
    case Wrap::clamp_to_edge:
      break;
  }
  return std::min(std::max(0.0F, coordinate), 1.0F);
}

/// The texel one step outside an edge, -1 or `size`, wrapped. Both clamping and mirroring repeat
/// the edge's texel there, as the coordinate itself is folded already.
inline int wrap_texel(int index, int size, Wrap wrap) {
  if (index < 0) {
    return wrap == Wrap::repeat ? size - 1 : 0;
  }
  if (index >= size) {
    return wrap == Wrap::repeat ? 0 : size - 1;
  }
  return index;
}

inline Eigen::Vector4f texel_at(const cv::Mat_<cv::Vec4b>& level, int row, int column) {
  const cv::Vec4b& texel = level(row, column);
  return {decode_srgb_8bit(texel[0]), decode_srgb_8bit(texel[1]), decode_srgb_8bit(texel[2]),
          static_cast<float>(texel[3]) * (1.0F / 255.0F)};
}

Eigen::Vector4f sample_nearest(const cv::Mat_<cv::Vec4b>& level, float u, float v) {
  const int column = std::min(static_cast<int>(u * static_cast<float>(level.cols)), level.cols - 1);
  const int row = std::min(static_cast<int>(v * static_cast<float>(level.rows)), level.rows - 1);
  return texel_at(level, row, column);
}

/// The two texels on either side of a folded coordinate and the share of the second.
struct Neighbours {
  int first = 0;
  int second = 0;
  float share = 0;
};

inline Neighbours find_neighbours(float coordinate, int size, Wrap wrap) {
  const float position = coordinate * static_cast<float>(size) - 0.5F;  // -0.5 or more
  const int below = position < 0 ? -1 : static_cast<int>(position);
  return {wrap_texel(below, size, wrap), wrap_texel(below + 1, size, wrap),
          position - static_cast<float>(below)};
}

Eigen::Vector4f sample_bilinear(const cv::Mat_<cv::Vec4b>& level, const Texture& texture, float u,
                                float v) {
  const Neighbours x = find_neighbours(u, level.cols, texture.wrap_u);
  const Neighbours y = find_neighbours(v, level.rows, texture.wrap_v);
  const Eigen::Vector4f upper = (1 - x.share) * texel_at(level, y.first, x.first) +
                                x.share * texel_at(level, y.first, x.second);
  const Eigen::Vector4f lower = (1 - x.share) * texel_at(level, y.second, x.first) +
                                x.share * texel_at(level, y.second, x.second);
  return (1 - y.share) * upper + y.share * lower;
}

Eigen::Vector4f sample_level(const cv::Mat_<cv::Vec4b>& level, const Texture& texture,
                             TexelFilter filter, float u, float v) {
  return filter == TexelFilter::nearest ? sample_nearest(level, u, v)
                                        : sample_bilinear(level, texture, u, v);
}

}  // namespace

TextureImage build_mip_levels(const cv::Mat_<cv::Vec4b>& image) {
  TextureImage result;
  result.levels.push_back(image);
  cv::Mat_<cv::Vec4f> linear = decode_image(image);
  while (linear.rows > 1 || linear.cols > 1) {
    const cv::Size half(std::max(1, linear.cols / 2), std::max(1, linear.rows / 2));
    cv::Mat_<cv::Vec4f> smaller;
    cv::resize(linear, smaller, half, 0, 0, cv::INTER_AREA);
    result.levels.push_back(encode_image(smaller));
    linear = smaller;
  }
  return result;
}

Eigen::Vector4f sample(const TextureImage& image, const Texture& texture, const Eigen::Vector2f& uv,
                       float lod) {
  const float u = fold(uv.x(), texture.wrap_u);
  const float v = fold(uv.y(), texture.wrap_v);
  if (!(lod > 0)) {
    return sample_level(image.levels[0], texture, texture.magnification, u, v);
  }
  if (texture.mip == MipFilter::none) {
    return sample_level(image.levels[0], texture, texture.minification, u, v);
  }
  const std::size_t last = image.levels.size() - 1;
  const float level = std::min(lod, static_cast<float>(last));
  const auto finer = static_cast<std::size_t>(level);
  const float share = level - static_cast<float>(finer);
  if (texture.mip == MipFilter::nearest || share == 0) {
    const std::size_t nearest = share < 0.5F ? finer : finer + 1;
    return sample_level(image.levels[nearest], texture, texture.minification, u, v);
  }
  return (1 - share) * sample_level(image.levels[finer], texture, texture.minification, u, v) +
         share * sample_level(image.levels[finer + 1], texture, texture.minification, u, v);
}

}  // namespace synth
