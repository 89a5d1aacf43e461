#include "synth/denoising/denoise.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr int kWidth = 53;  // px, no multiple of a tile's edge
constexpr int kHeight = 38;

/// A wall that faces the camera and sends half of its light back, of light 1.
NoisyPicture wall() {
  NoisyPicture picture({kWidth, kHeight});
  picture.halves[0] = cv::Vec3f(0.5F, 0.5F, 0.5F);
  picture.halves[1] = cv::Vec3f(0.5F, 0.5F, 0.5F);
  picture.shown = cv::Vec3f(0, 0, 0);
  picture.reflectance = cv::Vec3f(0.5F, 0.5F, 0.5F);
  picture.normal = cv::Vec3f(0, 0, -1);
  picture.nearness = 0.5F;
  return picture;
}

/// Multiplies the radiance by a function of half, column and row.
template <typename Factor>
void shade(NoisyPicture& picture, Factor factor) {
  for (std::size_t half = 0; half < 2; ++half) {
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        picture.halves[half](v, u) *= static_cast<float>(factor(half, u, v));
      }
    }
  }
}

/// Multiplies the radiance by 1 plus independent noise of this deviation.
void add_noise(NoisyPicture& picture, double deviation) {
  const vo::RandomField field(7, 1, 0);
  shade(picture, [&](std::size_t half, int u, int v) {
    return 1 + deviation * field.normal(u, v, static_cast<int>(half));
  });
}

cv::Mat_<cv::Vec3f> noisy_radiance(const NoisyPicture& picture) {
  cv::Mat_<cv::Vec3f> mean;
  cv::addWeighted(picture.halves[0], 0.5, picture.halves[1], 0.5, 0, mean);
  cv::add(mean, picture.shown, mean);
  return mean;
}

/// Returns the root-mean-square difference of two images, all channels together.
double rms(const cv::Mat_<cv::Vec3f>& a, const cv::Mat_<cv::Vec3f>& b) {
  return cv::norm(a, b, cv::NORM_L2) / std::sqrt(3.0 * static_cast<double>(a.total()));
}

/// Returns an image turned by columns, what leaves it on the right coming in on the left.
template <typename Image>
Image turned(const Image& image, int columns) {
  Image result;
  cv::hconcat(image.colRange(image.cols - columns, image.cols),
              image.colRange(0, image.cols - columns), result);
  return result;
}

TEST(Denoise, OfAPictureThatGoesRoundTurnsWithThePicture) {
  NoisyPicture picture = wall();
  shade(picture, [](std::size_t, int u, int v) { return u < 9 || v > 30 ? 3 : 1; });
  add_noise(picture, 0.3);
  picture.halves[0](7, 2) *= 1000;  // is dimmed and given back
  NoisyPicture other = picture;
  constexpr int kTurn = 20;
  for (std::size_t half = 0; half < 2; ++half) {
    other.halves[half] = turned(picture.halves[half], kTurn);
  }
  const cv::Mat_<cv::Vec3f> expected = turned(denoised_round(picture), kTurn);
  EXPECT_LT(rms(denoised_round(other), expected), 1e-6);
  EXPECT_GT(rms(denoised(other), turned(denoised(picture), kTurn)), 1e-3);
}

TEST(Denoise, AnEvenImageStaysAsItIs) {
  const NoisyPicture picture = wall();
  EXPECT_LT(cv::norm(denoised(picture), noisy_radiance(picture), cv::NORM_INF), 1e-6);
}

TEST(Denoise, WithoutNoiseAnyImageStaysAsItIs) {
  NoisyPicture picture = wall();
  const vo::RandomField field(3, 1, 0);
  shade(picture, [&](std::size_t, int u, int v) { return 1 + 0.3 * field.uniform(u, v); });
  EXPECT_LT(cv::norm(denoised(picture), noisy_radiance(picture), cv::NORM_INF), 1e-3);
}

TEST(Denoise, LightThatIsShownComesThroughToTheBit) {
  NoisyPicture picture = wall();
  picture.halves[0].setTo(0);
  picture.halves[1].setTo(0);
  const vo::RandomField field(5, 1, 0);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      picture.shown(v, u)[1] = static_cast<float>(100 * field.uniform(u, v));
    }
  }
  EXPECT_EQ(cv::norm(denoised(picture), picture.shown, cv::NORM_INF), 0);
}

TEST(Denoise, NoiseOnAnEvenImageFallsToATenth) {
  NoisyPicture picture = wall();
  const cv::Mat_<cv::Vec3f> truth = noisy_radiance(picture);
  add_noise(picture, 0.3);
  EXPECT_LT(rms(denoised(picture), truth), 0.1 * rms(noisy_radiance(picture), truth));
}

TEST(Denoise, ATextureStaysSharp) {
  NoisyPicture picture = wall();
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const float factor = (u / 2 + v / 2) % 2 == 0 ? 1.0F : 0.9F;
      picture.reflectance(v, u) *= factor;
      picture.halves[0](v, u) *= factor;
      picture.halves[1](v, u) *= factor;
    }
  }
  const cv::Mat_<cv::Vec3f> truth = noisy_radiance(picture);
  add_noise(picture, 0.3);
  EXPECT_LT(rms(denoised(picture), truth), 0.1 * rms(noisy_radiance(picture), truth));
}

TEST(Denoise, ARampThatANormalExplainsIsKept) {
  NoisyPicture picture = wall();
  const auto light = [](int u) { return 0.5 + u / (2.0 * kWidth); };
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const auto x = static_cast<float>(3.2 * (light(u) - 0.75));  // -0.8 to 0.8
      picture.normal(v, u) = {x, 0, -std::sqrt(1 - x * x)};
    }
  }
  shade(picture, [&](std::size_t, int u, int) { return light(u); });
  const cv::Mat_<cv::Vec3f> truth = noisy_radiance(picture);
  add_noise(picture, 0.1);
  const cv::Mat_<cv::Vec3f> result = denoised(picture);
  EXPECT_LT(rms(result, truth), 0.25 * rms(noisy_radiance(picture), truth));
  for (const int u : {1, kWidth / 2, kWidth - 2}) {  // at the borders the window is one-sided
    EXPECT_NEAR(cv::mean(result.col(u))[1], 0.5 * light(u), 0.006) << u;
  }
}

TEST(Denoise, AnEdgeOfDepthKeepsTheLightOfItsSides) {
  NoisyPicture picture = wall();
  picture.nearness.colRange(0, 20) = 1;
  shade(picture, [](std::size_t, int u, int) { return u < 20 ? 0.1 : 1; });
  const cv::Mat_<cv::Vec3f> truth = noisy_radiance(picture);
  add_noise(picture, 0.3);
  const cv::Mat_<cv::Vec3f> result = denoised(picture);
  EXPECT_NEAR(cv::mean(result.col(19))[1], 0.05, 0.003);
  EXPECT_NEAR(cv::mean(result.col(20))[1], 0.5, 0.03);
}

TEST(Denoise, AFireflyIsSpreadAndItsLightKept) {
  NoisyPicture picture = wall();
  picture.halves[0](17, 30) *= 1000;
  const cv::Mat_<cv::Vec3f> result = denoised(picture);
  EXPECT_LT(result(17, 30)[1], 1.5);
  EXPECT_NEAR(cv::mean(result)[1], cv::mean(noisy_radiance(picture))[1], 0.02);
}

TEST(Denoise, ErrorsFallWithTheNoise) {
  double last = 1;
  for (const double deviation : {0.4, 0.2, 0.1, 0.05}) {
    NoisyPicture picture = wall();
    shade(picture, [](std::size_t, int u, int v) { return 1 + 0.5 * std::sin(u / 4.0 + v / 7.0); });
    const cv::Mat_<cv::Vec3f> truth = noisy_radiance(picture);
    add_noise(picture, deviation);
    const double error = rms(denoised(picture), truth);
    EXPECT_LT(error, 0.8 * last);
    EXPECT_LT(error, rms(noisy_radiance(picture), truth));
    last = error;
  }
}

}  // namespace
}  // namespace synth
