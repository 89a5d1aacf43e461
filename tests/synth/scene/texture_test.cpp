#include "synth/scene/texture.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace synth {
namespace {

using Eigen::Vector2f;
using Eigen::Vector4f;

constexpr float kTexelRounding = 1e-6F;  // of linear values up to 1
constexpr float kHalfStep = 0.005F;      // linear, half an 8-bit sRGB step near white

/// The transfer function as IEC 61966-2-1 states it.
double srgb_to_linear(int code) {
  const double c = code / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

cv::Vec4b grey(int code, int alpha = 255) {
  const auto value = static_cast<uchar>(code);
  return {value, value, value, static_cast<uchar>(alpha)};
}

/// Black, dark, light, white from left to right.
TextureImage ramp() {
  return build_mip_levels((cv::Mat_<cv::Vec4b>(1, 4) << grey(0), grey(85), grey(170), grey(255)));
}

TextureImage checkerboard(int rows, int columns) {
  cv::Mat_<cv::Vec4b> image(rows, columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      image(row, column) = grey((row + column) % 2 == 0 ? 255 : 0);
    }
  }
  return build_mip_levels(image);
}

float red(const TextureImage& image, const Texture& texture, float u, float v, float lod = 0) {
  return sample(image, texture, {u, v}, lod)[0];
}

TEST(Texture, DecodesSrgbAndLeavesAlphaLinear) {
  for (int code = 0; code < 256; ++code) {
    const TextureImage image = build_mip_levels(cv::Mat_<cv::Vec4b>(1, 1, grey(code, code)));
    const Vector4f color = sample(image, {}, {0.5F, 0.5F}, 0);
    EXPECT_NEAR(color[0], srgb_to_linear(code), kTexelRounding);
    EXPECT_NEAR(color[3], code / 255.0, kTexelRounding);
  }
}

TEST(Texture, HasItsTexelCentresAtHalves) {
  for (int i = 0; i < 4; ++i) {
    const float u = (static_cast<float>(i) + 0.5F) / 4;
    EXPECT_NEAR(red(ramp(), {}, u, 0.5F), srgb_to_linear(85 * i), kTexelRounding);
  }
}

TEST(Texture, InterpolatesInLinearLight) {
  EXPECT_NEAR(red(ramp(), {}, 0.75F, 0.5F), (srgb_to_linear(170) + 1) / 2, kTexelRounding);
}

TEST(Texture, TakesTheTexelAroundThePointWhenNearest) {
  const Texture texture{.magnification = TexelFilter::nearest};
  EXPECT_EQ(red(ramp(), texture, 0.2499F, 0.5F), 0);
  EXPECT_NEAR(red(ramp(), texture, 0.2501F, 0.5F), srgb_to_linear(85), kTexelRounding);
  EXPECT_EQ(red(ramp(), texture, 0.9999F, 0.5F), 1);
}

TEST(Texture, RepeatsAcrossItsEdges) {
  const Texture texture{.wrap_u = Wrap::repeat};
  EXPECT_NEAR(red(ramp(), texture, 0, 0.5F), 0.5F, kTexelRounding);
  EXPECT_NEAR(red(ramp(), texture, 1, 0.5F), 0.5F, kTexelRounding);
  EXPECT_NEAR(red(ramp(), texture, -2.125F, 0.5F), 1, kTexelRounding);
  EXPECT_NEAR(red(ramp(), texture, 3.375F, 0.5F), srgb_to_linear(85), kTexelRounding);
}

TEST(Texture, HoldsItsEdgesWhenClamped) {
  const Texture texture{.wrap_u = Wrap::clamp_to_edge};
  EXPECT_EQ(red(ramp(), texture, -5, 0.5F), 0);
  EXPECT_EQ(red(ramp(), texture, 0.05F, 0.5F), 0);
  EXPECT_EQ(red(ramp(), texture, 5, 0.5F), 1);
}

TEST(Texture, MirrorsEveryOtherRepetition) {
  const Texture texture{.wrap_u = Wrap::mirrored_repeat};
  for (const float u : {0.1F, 0.3F, 0.49F, 0.8F, 0.99F}) {
    const float inside = red(ramp(), texture, u, 0.5F);
    EXPECT_NEAR(red(ramp(), texture, -u, 0.5F), inside, kTexelRounding);
    EXPECT_NEAR(red(ramp(), texture, 2 - u, 0.5F), inside, 1e-5F);
    EXPECT_NEAR(red(ramp(), texture, 2 + u, 0.5F), inside, 1e-5F);
  }
}

TEST(Texture, HasMipLevelsDownToOneTexel) {
  const TextureImage image = checkerboard(5, 12);
  ASSERT_EQ(image.levels.size(), 4U);
  EXPECT_EQ(image.levels[1].size(), cv::Size(6, 2));
  EXPECT_EQ(image.levels[2].size(), cv::Size(3, 1));
  EXPECT_EQ(image.levels[3].size(), cv::Size(1, 1));
}

TEST(Texture, KeepsItsMeanOverAllLevels) {
  const TextureImage image = checkerboard(64, 16);
  for (std::size_t level = 1; level < image.levels.size(); ++level) {
    const Texture texture{.mip = MipFilter::nearest};
    EXPECT_NEAR(red(image, texture, 0.3F, 0.7F, static_cast<float>(level)), 0.5F, kHalfStep);
  }
}

TEST(Texture, AveragesByAreaWhereSizesAreOdd) {
  cv::Mat_<cv::Vec4b> image(1, 3, grey(0));
  image(0, 1) = grey(255);
  const TextureImage levels = build_mip_levels(image);
  EXPECT_NEAR(red(levels, {}, 0.5F, 0.5F, 1), 1.0F / 3, kHalfStep);
}

TEST(Texture, BlendsNeighbouringLevels) {
  const TextureImage image = checkerboard(2, 2);
  const Texture texture{.minification = TexelFilter::nearest, .mip = MipFilter::linear};
  const float coarse = red(image, texture, 0.25F, 0.25F, 1);
  EXPECT_NEAR(red(image, texture, 0.25F, 0.25F, 0.25F), 0.75F + 0.25F * coarse, kTexelRounding);
}

TEST(Texture, UsesItsFullImageWithoutMipFilter) {
  const Texture texture{.minification = TexelFilter::nearest, .mip = MipFilter::none};
  EXPECT_EQ(red(checkerboard(4, 4), texture, 0.1F, 0.1F, 10), 1);
}

TEST(Texture, IsDefinedForAnyCoordinate) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
    const Texture texture{.wrap_u = wrap, .wrap_v = wrap};
    for (const float x : {infinity, -infinity, std::nanf(""), 1e30F, -1e30F, -1e-9F}) {
      EXPECT_TRUE(sample(ramp(), texture, Vector2f(x, x), 0.7F).allFinite());
    }
  }
}

}  // namespace
}  // namespace synth
