#include "synth/denoising/other_frames.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "vo/core/random_field.h"

namespace synth {
namespace {

const cv::Size kSize(40, 30);
const cv::Rect kMiddle(4, 4, 30, 20);  // without the pixels that some frames do not show

/// A wall at 2 m that sends `reflectance` of its light back, which is `light` and noise of 20 %.
NoisyPicture noisy_wall(std::uint64_t seed, float reflectance = 0.5F, float light = 1) {
  NoisyPicture picture(kSize);
  picture.shown = cv::Vec3f(0, 0, 0);
  picture.reflectance = cv::Vec3f::all(reflectance);
  picture.normal = cv::Vec3f(0, 0, -1);
  picture.nearness = 0.5F;
  const vo::RandomField field(seed, 1, 0);
  for (int half = 0; half < 2; ++half) {
    for (int v = 0; v < kSize.height; ++v) {
      for (int u = 0; u < kSize.width; ++u) {
        const double noise = 0.2 * field.normal(u, v, half);
        picture.halves[static_cast<std::size_t>(half)](v, u) =
            cv::Vec3f::all(reflectance * light * static_cast<float>(1 + noise));
      }
    }
  }
  return picture;
}

/// A frame whose picture shows each pixel's point some pixels to the right and below.
OtherFrame shifted(const NoisyPicture& picture, const cv::Vec2f& way) {
  OtherFrame other{&picture, cv::Mat_<cv::Vec2f>(kSize), cv::Mat_<float>(kSize, 1.0F)};
  for (int v = 0; v < kSize.height; ++v) {
    for (int u = 0; u < kSize.width; ++u) {
      other.places(v, u) = cv::Vec2f(static_cast<float>(u), static_cast<float>(v)) + way;
    }
  }
  return other;
}

/// Returns the root-mean-square difference of a half's radiance from a value, in the middle.
double deviation(const NoisyPicture& picture, float radiance, std::size_t half = 0) {
  const cv::Mat_<cv::Vec3f> middle = picture.halves[half](kMiddle);
  return cv::norm(middle, cv::Mat_<cv::Vec3f>(middle.size(), cv::Vec3f::all(radiance)),
                  cv::NORM_L2) /
         std::sqrt(3.0 * static_cast<double>(middle.total()));
}

/// Returns whether two pictures have the same bytes in the halves of their samples.
bool is_same(const NoisyPicture& a, const NoisyPicture& b) {
  return cv::norm(a.halves[0], b.halves[0], cv::NORM_INF) == 0 &&
         cv::norm(a.halves[1], b.halves[1], cv::NORM_INF) == 0;
}

TEST(OtherFrames, AverageNoiseAwayThatIsIndependent) {
  const NoisyPicture picture = noisy_wall(1);
  std::vector<NoisyPicture> pictures;
  for (std::uint64_t seed = 2; seed < 10; ++seed) {
    pictures.push_back(noisy_wall(seed));
  }
  std::vector<OtherFrame> others;
  for (const NoisyPicture& other : pictures) {
    others.push_back(shifted(other, {3, 2}));
  }
  const NoisyPicture result = with_light_of(picture, others);
  // The mean of nine would have a third of the noise; what is unlike by chance counts less.
  EXPECT_LT(deviation(result, 0.5F), 0.45 * deviation(picture, 0.5F));
  EXPECT_LT(deviation(result, 0.5F, 1), 0.45 * deviation(picture, 0.5F, 1));
  EXPECT_NEAR(cv::mean(result.halves[0](kMiddle))[0], 0.5, 0.003);
}

TEST(OtherFrames, TellOfLightWhateverTheReflectance) {
  const NoisyPicture picture = noisy_wall(1);
  const NoisyPicture dark = noisy_wall(2, 0.1F);
  const NoisyPicture result = with_light_of(picture, {shifted(dark, {-1, 0})});
  EXPECT_LT(deviation(result, 0.5F), 0.8 * deviation(picture, 0.5F));
  EXPECT_NEAR(cv::mean(result.halves[0](kMiddle))[0], 0.5, 0.005);
}

TEST(OtherFrames, ThatDoNotSeeThePointTellNothing) {
  const NoisyPicture picture = noisy_wall(1);
  const NoisyPicture other = noisy_wall(2);
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(
      is_same(with_light_of(picture, {shifted(other, {kNone, 0})}), with_light_of(picture, {})));
  EXPECT_TRUE(
      is_same(with_light_of(picture, {shifted(other, {100, 0})}), with_light_of(picture, {})));
}

TEST(OtherFrames, WhereAnotherSurfaceIsTellNothing) {
  const NoisyPicture picture = noisy_wall(1);
  NoisyPicture nearer = noisy_wall(2);
  nearer.nearness = 0.6F;
  NoisyPicture turned = noisy_wall(2);
  turned.normal = cv::Vec3f(0, -0.6F, -0.8F);
  EXPECT_TRUE(
      is_same(with_light_of(picture, {shifted(nearer, {0, 0})}), with_light_of(picture, {})));
  EXPECT_TRUE(
      is_same(with_light_of(picture, {shifted(turned, {0, 0})}), with_light_of(picture, {})));
  OtherFrame closer = shifted(nearer, {0, 0});
  closer.nearness_ratio = 1.2F;  // the other camera is nearer to the same point
  EXPECT_LT(deviation(with_light_of(picture, {closer}), 0.5F), 0.8 * deviation(picture, 0.5F));
}

TEST(OtherFrames, OfOtherLightDoNotSmear) {
  const NoisyPicture picture = noisy_wall(1);
  const NoisyPicture brighter = noisy_wall(2, 0.5F, 1.5F);
  const NoisyPicture result =
      with_light_of(picture, {shifted(brighter, {0, 0}), shifted(brighter, {1, 0})});
  EXPECT_NEAR(cv::mean(result.halves[0](kMiddle))[0], cv::mean(picture.halves[0](kMiddle))[0],
              0.003);
}

TEST(OtherFrames, OfAPanoramaGoRound) {
  const NoisyPicture picture = noisy_wall(1);
  const NoisyPicture other = noisy_wall(2);
  OtherFrame round = shifted(other, {15.5F, 0});
  round.wraps = true;
  const OtherFrame ends = shifted(other, {15.5F, 0});
  const cv::Rect right(32, 0, 8, kSize.height);
  const cv::Mat own = picture.halves[0](right);
  EXPECT_GT(cv::norm(with_light_of(picture, {round}).halves[0](right), own, cv::NORM_L1),
            100 * cv::norm(with_light_of(picture, {ends}).halves[0](right), own, cv::NORM_L1));
}

}  // namespace
}  // namespace synth
