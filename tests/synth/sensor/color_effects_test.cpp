#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/depth_sensor/gaussian.h"
#include "synth/scene/srgb.h"
#include "synth/sensor/exposure_control.h"
#include "synth/sensor/image_noise.h"
#include "synth/sensor/jpeg.h"
#include "synth/sensor/lens.h"
#include "synth/sensor/response.h"
#include "tests/support/error_text.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

using support::error_text;
using testing::HasSubstr;

TEST(GaussianKernel, SumsToOne) {
  for (const double sigma : {0.0, 0.3, 0.7, 2.0}) {
    const std::vector<float> kernel = gaussian_kernel(sigma);
    const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
    EXPECT_NEAR(2 * sum - kernel[0], 1, 1e-6) << sigma;
  }
}

TEST(Blurred, PointHasTheSpreadOfItsSigmaAndKeepsItsLight) {
  cv::Mat_<cv::Vec3f> point(31, 31, cv::Vec3f(0, 0, 0));
  point(15, 15) = {1, 2, 3};
  const cv::Mat_<cv::Vec3f> spread = blurred(point, 1.5);
  EXPECT_NEAR(cv::sum(spread)[2], 3, 1e-5);
  double variance = 0;
  for (int u = 0; u < 31; ++u) {
    variance += (u - 15) * (u - 15) * cv::sum(spread.col(u))[0];
  }
  EXPECT_NEAR(variance, 1.5 * 1.5, 0.01);
}

TEST(Blurred, EvenLightStaysUpToTheBorder) {
  const cv::Mat_<cv::Vec3f> even(9, 9, cv::Vec3f(0.5F, 0.5F, 0.5F));
  EXPECT_LT(cv::norm(blurred(even, 2), even, cv::NORM_INF), 1e-6);
}

TEST(Vignetting, IsTheFourthPowerOfTheCosineOfAThinLens) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(101, 101, 90);
  const Eigen::Vector2d right(camera.cx + camera.fx, camera.cy);  // 45 deg
  EXPECT_NEAR(light_share(camera, right, {.cos_power = 4}), 0.25, 1e-12);
  EXPECT_NEAR(light_share(camera, {camera.cx, camera.cy}, {.cos_power = 4}), 1, 1e-12);
}

TEST(Vignetting, PolynomialIsInHalfDiagonals) {
  const auto camera = vo::PinholeCamera::from_horizontal_fov(300, 400, 60);
  const Eigen::Vector2d corner(camera.cx + 150, camera.cy + 200);
  EXPECT_NEAR(light_share(camera, corner, {.k2 = -0.2, .k4 = -0.1}), 0.7, 1e-12);
  const cv::Mat_<cv::Vec3f> even(400, 300, cv::Vec3f(1, 1, 1));
  const cv::Mat_<cv::Vec3f> seen = through_lens(even, camera, {.vignetting = {.k2 = -0.2}});
  EXPECT_NEAR(seen(0, 0)[1], 1 - 0.2 * (149.5 * 149.5 + 199.5 * 199.5) / (250.0 * 250), 1e-6);
}

struct Moments {
  double mean = 0;
  double variance = 0;
};

/// Of 160 x 120 pixels of one linear value.
Moments noise_moments(float linear, const ImageNoiseOptions& options, double amplification) {
  const cv::Mat_<cv::Vec3f> even(120, 160, cv::Vec3f(linear, linear, linear));
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(with_image_noise(even, options, amplification, 5), mean, deviation);
  return {mean[1], deviation[1] * deviation[1]};
}

TEST(ImageNoise, HasTheVarianceOfShotAndReadNoiseAtEveryMean) {
  const ImageNoiseOptions options{.full_well = {5000, 5000, 5000}, .read_noise = {12, 12, 12}};
  for (const float linear : {0.0F, 0.001F, 0.01F, 0.1F, 0.5F, 0.9F}) {
    for (const double amplification : {1.0, 4.0}) {
      const double electrons_at_one = 5000 / amplification;
      const double expected =
          linear / electrons_at_one + std::pow(12 / electrons_at_one, 2);  // photon transfer
      const Moments moments = noise_moments(linear, options, amplification);
      EXPECT_NEAR(moments.mean, linear, 4 * std::sqrt(expected / 19200) + 1e-7);
      EXPECT_NEAR(moments.variance / expected, 1, 4 * std::sqrt(2 / 19200.0) + 0.005) << linear;
    }
  }
}

TEST(ImageNoise, CountsFewPhotonsAsPoissonDoes) {
  const vo::RandomField random(3, 0, 0);
  int none = 0;
  int one = 0;
  for (int i = 0; i < 100000; ++i) {
    const double count = poisson(0.7, random.uniform(i, 0), 0);
    none += count == 0 ? 1 : 0;
    one += count == 1 ? 1 : 0;
  }
  EXPECT_NEAR(none / 1e5, std::exp(-0.7), 0.006);
  EXPECT_NEAR(one / 1e5, 0.7 * std::exp(-0.7), 0.006);
}

TEST(ImageNoise, OfThePixelsGainsIsTheSameInEveryFrame) {
  const ImageNoiseOptions options{.full_well = {1e9, 1e9, 1e9}, .pixel_gain = 0.02};
  const cv::Mat_<cv::Vec3f> even(60, 80, cv::Vec3f(0.5F, 0.5F, 0.5F));
  const cv::Mat first = with_image_noise(even, options, 1, 0);
  EXPECT_LT(cv::norm(first, with_image_noise(even, options, 1, 1), cv::NORM_INF), 5e-4);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(first, mean, deviation);
  EXPECT_NEAR(deviation[0], 0.01, 0.0005);
}

TEST(ImageNoise, ExpectsAFullWell) {
  EXPECT_THAT(error_text([] {
                ImageNoiseOptions{.read_noise = {1, 1, 1}}.validate();
              }),
              HasSubstr("expect a full_well above 0"));
}

cv::Vec3b code_of(float linear, const ResponseOptions& response) {
  return encode(cv::Mat_<cv::Vec3f>(1, 1, cv::Vec3f(linear, 0, 1)), response)(0, 0);
}

TEST(Response, OfSrgbIsTheStandards) {
  for (const float linear : {-1.0F, 0.0F, 0.002F, 0.18F, 0.7F, 1.0F, 3.0F}) {
    EXPECT_EQ(code_of(linear, {}), cv::Vec3b(255, 0, encode_srgb_8bit(linear)));
  }
}

TEST(Response, OfGammaIsAPower) {
  const ResponseOptions gamma{.curve = ResponseCurve::gamma, .gamma = 2};
  EXPECT_EQ(code_of(0.25F, gamma)[2], 128);  // 127.5 and above
  EXPECT_EQ(code_of(0.24F, gamma)[2], std::lround(255 * std::sqrt(0.24)));
}

TEST(Response, OfATableIsLinearBetweenItsValues) {
  const ResponseOptions table{.curve = ResponseCurve::table, .table = "0, 0.6, 1"};
  table.validate();
  EXPECT_EQ(code_of(0.5F, table)[2], 153);
  EXPECT_EQ(code_of(0.25F, table)[2], std::lround(255 * 0.3));
  EXPECT_EQ(code_of(0.75F, table)[2], 204);
}

TEST(Response, ExpectsARisingTable) {
  const auto message = [](const char* text) {
    return error_text(
        [&] { ResponseOptions{.curve = ResponseCurve::table, .table = text}.validate(); });
  };
  EXPECT_THAT(message(""), HasSubstr("sensor.response.table: expected 1 numbers"));
  EXPECT_THAT(message("0, 0.7, 0.6, 1"), HasSubstr("expected rising numbers, got 0.6 after 0.7"));
  EXPECT_THAT(message("0, 0.7"), HasSubstr("expected at least two numbers from 0 to 1"));
}

vo::ColorImage noisy_image() {
  const vo::RandomField random(1, 2, 3);
  vo::ColorImage image(37, 53);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const auto grey = static_cast<uchar>(100 + 50 * random.uniform(u, v));
      image(v, u) = {grey, grey, grey};
    }
  }
  return image;
}

TEST(Jpeg, ErrsMoreTheLowerItsQuality) {
  const vo::ColorImage image = noisy_image();
  const auto error = [&](int quality) {
    return cv::norm(through_jpeg(image, {.quality = quality}), image) /
           std::sqrt(3.0 * image.rows * image.cols);
  };
  EXPECT_LT(error(100), 1);
  EXPECT_GT(error(50), 3 * error(100));
  EXPECT_GT(error(10), error(50));
}

TEST(Jpeg, KeepsAnEvenColor) {
  const vo::ColorImage even(40, 24, cv::Vec3b(40, 120, 200));
  EXPECT_LE(cv::norm(through_jpeg(even, {.quality = 75}), even, cv::NORM_INF), 4);
}

TEST(Followed, StepIsApproachedExponentiallyAfterTheDelay) {
  std::vector<double> times;
  std::vector<double> wanted;
  for (int i = 0; i < 60; ++i) {
    times.push_back(i / 30.0);
    wanted.push_back(i < 10 ? 0 : 1);
  }
  const std::vector<double> settings = followed(times, wanted, 0.3, 0.1);
  for (std::size_t i = 0; i < 60; ++i) {
    const double frames = std::max(0.0, static_cast<double>(i) - 12);  // 10, and 3 of delay
    EXPECT_NEAR(settings[i], 1 - std::exp(-frames / 30 / 0.3), 1e-9) << i;
  }
}

TEST(Followed, FrameNeverActsOnItself) {
  EXPECT_EQ(followed({0, 1, 2, 3}, {0, 5, 7, 9}, 0, 0), (std::vector<double>{0, 0, 5, 7}));
}

}  // namespace
}  // namespace synth
