#include "synth/scene/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <opencv2/imgproc.hpp>

#include "synth/scene/srgb.h"

namespace synth {
namespace {

constexpr float kCodeStep = 1.0F / 255.0F;

std::array<float, 256> make_even_codes() {
  std::array<float, 256> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = static_cast<float>(i) * kCodeStep;
  }
  return values;
}

const std::array<float, 256> kEvenCodes = make_even_codes();

/// Returns the linear value of each 8-bit code of a colour channel.
inline const std::array<float, 256>& decoding_table(TexelEncoding encoding) {
  return encoding == TexelEncoding::srgb ? kLinearFromSrgb8bit : kEvenCodes;
}

std::uint8_t encode(float value, TexelEncoding encoding) {
  return encoding == TexelEncoding::srgb ? encode_srgb_8bit(value)
                                         : cv::saturate_cast<std::uint8_t>(value * 255.0F);
}

cv::Mat_<cv::Vec4f> decode_image(const cv::Mat_<cv::Vec4b>& image, TexelEncoding encoding) {
  const std::array<float, 256>& values = decoding_table(encoding);
  cv::Mat_<cv::Vec4f> linear(image.size());
  std::transform(image.begin(), image.end(), linear.begin(), [&](const cv::Vec4b& texel) {
    return cv::Vec4f(values[texel[0]], values[texel[1]], values[texel[2]],
                     static_cast<float>(texel[3]) / 255.0F);
  });
  return linear;
}

cv::Mat_<cv::Vec4b> encode_image(const cv::Mat_<cv::Vec4f>& linear, TexelEncoding encoding) {
  cv::Mat_<cv::Vec4b> image(linear.size());
  std::transform(linear.begin(), linear.end(), image.begin(), [&](const cv::Vec4f& texel) {
    return cv::Vec4b(encode(texel[0], encoding), encode(texel[1], encoding),
                     encode(texel[2], encoding),
                     cv::saturate_cast<std::uint8_t>(texel[3] * 255.0F));
  });
  return image;
}

cv::Size half_of(const cv::Size& size) {
  return {std::max(1, size.width / 2), std::max(1, size.height / 2)};
}

cv::Mat_<cv::Vec4f> halve(const cv::Mat_<cv::Vec4f>& linear) {
  cv::Mat_<cv::Vec4f> smaller;
  cv::resize(linear, smaller, half_of(linear.size()), 0, 0, cv::INTER_AREA);
  return smaller;
}

/// Decodes and halves an image, strip by strip if its number of rows is even, as its linear values
/// take four times its memory.
cv::Mat_<cv::Vec4f> decode_halved(const cv::Mat_<cv::Vec4b>& image, TexelEncoding encoding) {
  constexpr int kStrip = 64;  // rows
  if (image.rows % 2 != 0) {
    return halve(decode_image(image, encoding));
  }
  cv::Mat_<cv::Vec4f> halved(half_of(image.size()));
  for (int begin = 0; begin < image.rows; begin += kStrip) {
    const int end = std::min(begin + kStrip, image.rows);
    halve(decode_image(image.rowRange(begin, end), encoding))
        .copyTo(halved.rowRange(begin / 2, end / 2));
  }
  return halved;
}

/// Brings a texture coordinate into [0, 1] by the wrap mode. NaN becomes 0.
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

/// Wraps a texel index that is at most one step outside an edge, from -1 to `size`. Clamping and
/// mirroring both repeat the edge's texel there, as the coordinate itself is folded already.
inline int wrap_texel(int index, int size, Wrap wrap) {
  if (index < 0) {
    return wrap == Wrap::repeat ? size - 1 : 0;
  }
  if (index >= size) {
    return wrap == Wrap::repeat ? 0 : size - 1;
  }
  return index;
}

struct Level {
  const cv::Mat_<cv::Vec4b>& texels;
  const std::array<float, 256>& values;  ///< linear value of each colour code
};

inline Eigen::Vector4f decode(const cv::Vec4b& texel, const std::array<float, 256>& values) {
  return {values[texel[0]], values[texel[1]], values[texel[2]], kEvenCodes[texel[3]]};
}

Eigen::Vector4f sample_nearest(const Level& level, float u, float v) {
  const cv::Size size = level.texels.size();
  const int column = std::min(static_cast<int>(u * static_cast<float>(size.width)), size.width - 1);
  const int row = std::min(static_cast<int>(v * static_cast<float>(size.height)), size.height - 1);
  return decode(level.texels(row, column), level.values);
}

/// The two texels on either side of a folded coordinate, and the second one's weight in `share`.
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

Eigen::Vector4f sample_bilinear(const Level& level, const Texture& texture, float u, float v) {
  const Neighbours x = find_neighbours(u, level.texels.cols, texture.wrap_u);
  const Neighbours y = find_neighbours(v, level.texels.rows, texture.wrap_v);
  const auto row = [&](int index) -> Eigen::Vector4f {
    const cv::Vec4b* texels = level.texels[index];
    return (1 - x.share) * decode(texels[x.first], level.values) +
           x.share * decode(texels[x.second], level.values);
  };
  return (1 - y.share) * row(y.first) + y.share * row(y.second);
}

Eigen::Vector4f sample_level(const TextureImage& image, std::size_t index, const Texture& texture,
                             TexelFilter filter, const Eigen::Vector2f& uv) {
  const Level level{image.levels[index], decoding_table(image.encoding)};
  return filter == TexelFilter::nearest ? sample_nearest(level, uv.x(), uv.y())
                                        : sample_bilinear(level, texture, uv.x(), uv.y());
}

}  // namespace

TextureImage build_mip_levels(const cv::Mat_<cv::Vec4b>& image, TexelEncoding encoding) {
  TextureImage result;
  result.encoding = encoding;
  result.levels.push_back(image);
  cv::Mat_<cv::Vec4f> linear;
  while (result.levels.back().total() > 1) {
    linear = linear.empty() ? decode_halved(image, encoding) : halve(linear);
    result.levels.push_back(encode_image(linear, encoding));
  }
  return result;
}

Eigen::Vector4f sample(const TextureImage& image, const Texture& texture, const Eigen::Vector2f& uv,
                       float lod) {
  const Eigen::Vector2f folded(fold(uv.x(), texture.wrap_u), fold(uv.y(), texture.wrap_v));
  if (!(lod > 0)) {
    return sample_level(image, 0, texture, texture.magnification, folded);
  }
  if (texture.mip == MipFilter::none) {
    return sample_level(image, 0, texture, texture.minification, folded);
  }
  const std::size_t last = image.levels.size() - 1;
  const float level = std::min(lod, static_cast<float>(last));
  const auto finer = static_cast<std::size_t>(level);
  const float share = level - static_cast<float>(finer);
  if (texture.mip == MipFilter::nearest || share == 0) {
    const std::size_t nearest = share < 0.5F ? finer : finer + 1;
    return sample_level(image, nearest, texture, texture.minification, folded);
  }
  return (1 - share) * sample_level(image, finer, texture, texture.minification, folded) +
         share * sample_level(image, finer + 1, texture, texture.minification, folded);
}

}  // namespace synth
