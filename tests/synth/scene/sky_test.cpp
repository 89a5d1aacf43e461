#include "synth/scene/sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace synth {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Environment sky_at(double elevation_deg, double turbidity = 3) {
  return clear_sky({elevation_deg * kDegree, turbidity});
}

/// Returns the luminance of linear light with sRGB's primaries.
double luminance(const cv::Vec3f& rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

double solid_angle(const Environment& sky, int v) {
  const double step = std::numbers::pi / sky.radiance.rows;
  return step * (std::cos(v * step) - std::cos((v + 1) * step));
}

TEST(ClearSky, HasThePapersLuminanceAtTheZenithAndIsBlueThere) {
  for (const double turbidity : {2.0, 3.0, 6.0}) {
    const Environment sky = sky_at(45, turbidity);
    const double chi = (4.0 / 9 - turbidity / 120) * (90 * kDegree);
    const double zenith =
        (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
    EXPECT_NEAR(luminance(sky.radiance(0, 0)), 1000 * zenith, 0.01 * 1000 * zenith);
    EXPECT_GT(sky.radiance(0, 0)[2], sky.radiance(0, 0)[0]);
  }
}

TEST(ClearSky, IsSymmetricAboutTheSunWhichIsBrightest) {
  const Environment sky = sky_at(30);
  const cv::Mat_<cv::Vec3f>& image = sky.radiance;
  double greatest = 0;
  for (int v = 0; v < image.rows / 2; ++v) {
    for (int u = 1; u < image.cols / 2; ++u) {
      const cv::Vec3f& left = image(v, image.cols / 2 - 1 - u);
      const cv::Vec3f& right = image(v, image.cols / 2 + u);
      ASSERT_NEAR(left[1], right[1], 1e-3 * right[1]) << v << ", " << u;
      greatest = std::max(greatest, luminance(right));
    }
  }
  const int row = static_cast<int>(60.0 / 180 * image.rows);
  EXPECT_GT(luminance(image(row, image.cols / 2)), 1000 * greatest);
}

TEST(ClearSky, TheSunHasWhatTheAirLeavesOfIt) {
  const Environment sky = sky_at(90);
  const cv::Vec3f disc = sky.radiance(0, sky.radiance.cols / 2) - sky.radiance(0, 0);
  const double green = disc[1] * solid_angle(sky, 0);  // lx, through one air mass
  EXPECT_NEAR(green, 128e3 * std::exp(-0.098 * 3), 1e-3 * green);
}

TEST(ClearSky, ALowSunIsRedderThanAHighOne) {
  const auto redness = [](double elevation_deg) {
    const Environment sky = sky_at(elevation_deg);
    const int row = static_cast<int>((90 - elevation_deg) / 180 * sky.radiance.rows);
    const cv::Vec3f& sun = sky.radiance(row, sky.radiance.cols / 2);
    return sun[0] / sun[2];
  };
  EXPECT_GT(redness(5), 3 * redness(60));
}

TEST(ClearSky, TheGroundReflectsAFifthOfWhatReachesIt) {
  const Environment sky = sky_at(40);
  double irradiance = 0;
  for (int v = 0; v < sky.radiance.rows / 2; ++v) {
    for (const cv::Vec3f& pixel : cv::Mat_<cv::Vec3f>(sky.radiance.row(v))) {
      irradiance += solid_angle(sky, v) * pixel[1] *
                    std::cos((v + 0.5) * std::numbers::pi / sky.radiance.rows);
    }
  }
  const double ground = sky.radiance(sky.radiance.rows - 1, 0)[1];
  EXPECT_NEAR(ground, 0.2 / std::numbers::pi * irradiance, 0.01 * ground);
}

TEST(ClearSky, SaysWhatIsOutOfRange) {
  using testing::HasSubstr;
  EXPECT_THAT(support::error_text([] { sky_at(-1); }),
              HasSubstr("the sun is -1 deg above the horizon, expected 0 to 90"));
  EXPECT_THAT(support::error_text([] { sky_at(30, 1); }),
              HasSubstr("a turbidity of 1, expected 1.8 to 10"));
}

}  // namespace
}  // namespace synth
