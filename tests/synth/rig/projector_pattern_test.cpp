#include "synth/rig/projector_pattern.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/support/error_text.h"
#include "tests/support/same_pixels.h"
#include "tests/support/temp_folder.h"
#include "vo/image_files/png.h"

namespace synth {
namespace {

using support::error_text;
using support::have_same_pixels;
using testing::AllOf;
using testing::HasSubstr;

vo::RigProjector dots(int number, double diameter_deg, std::uint64_t seed = 1) {
  vo::RigProjector projector;
  projector.name = "dots";
  projector.place = "rig.toml:7";
  projector.fov_deg = {86, 57};
  projector.dots = {number, diameter_deg, seed};
  return projector;
}

vo::RigProjector of_file(const std::filesystem::path& path) {
  vo::RigProjector projector = dots(1, 1);
  projector.pattern = path.filename();
  projector.folder = path.parent_path();
  return projector;
}

TEST(RandomDots, OneHasItsDiameterAndTheProfileOfItsFormula) {
  const vo::RigProjector projector = dots(1, 2);
  const cv::Mat_<float> pattern = pattern_of(projector);
  const Eigen::Vector2d half = half_extent_of(projector);
  EXPECT_NEAR(half.x(), std::tan(43 * std::numbers::pi / 180), 1e-12);
  // The light of cos^2(pi r / (2 d)) over its disc r < d is (pi / 2 - 2 / pi) d^2.
  const double diameter = 2 * std::tan(std::numbers::pi / 180);
  const double pixel = 4 * half.x() * half.y() / static_cast<double>(pattern.total());
  const double light = (std::numbers::pi / 2 - 2 / std::numbers::pi) * diameter * diameter;
  EXPECT_NEAR(cv::sum(pattern)[0] * pixel, light, 0.02 * light);
  double most = 0;
  cv::minMaxLoc(pattern, nullptr, &most);
  EXPECT_GT(most, 0.8);  // the centre is at most half a pixel's diagonal off the nearest pixel
  EXPECT_LE(most, 1);
}

TEST(RandomDots, AreAsManyAsAskedForAndEvenlySpread) {
  const cv::Mat_<float> pattern = pattern_of(dots(4096, 0.2));
  const double of_one = cv::sum(pattern_of(dots(1, 0.2)))[0];
  EXPECT_NEAR(cv::sum(pattern)[0], 4096 * of_one, 0.06 * 4096 * of_one);  // some overlap
  for (int part = 0; part < 64; ++part) {  // each of which holds 64 dots
    const cv::Rect box(pattern.cols * (part % 8) / 8, pattern.rows * (part / 8) / 8,
                       pattern.cols / 8, pattern.rows / 8);
    EXPECT_NEAR(cv::sum(pattern(box))[0], 64 * of_one, 0.2 * 64 * of_one);
  }
}

TEST(RandomDots, AreThoseOfTheirSeed) {
  const cv::Mat_<float> pattern = pattern_of(dots(100, 1, 5));
  EXPECT_TRUE(have_same_pixels(pattern, pattern_of(dots(100, 1, 5))));
  EXPECT_FALSE(have_same_pixels(pattern, pattern_of(dots(100, 1, 6))));
}

TEST(RandomDots, TooSmallForAPictureAreRefusedWithTheLeastDiameter) {
  const std::string error = error_text([] { pattern_of(dots(10, 0.01)); });
  EXPECT_THAT(error, HasSubstr("rig.toml:7: projector 'dots': dots.diameter_deg: expected at least "
                               "0.1044 deg in this field of view, got 0.01"));
  EXPECT_EQ(pattern_of(dots(10, 0.1044)).cols, 4095);
}

TEST(PatternFile, HasTheLinearLightOfItsValues) {
  const support::TempFolder folder;
  const cv::Mat grey = (cv::Mat_<std::uint8_t>(1, 3) << 0, 51, 255);
  const cv::Mat_<float> of_grey = pattern_of(of_file(folder.write("g.png", vo::encode_png(grey))));
  EXPECT_EQ(of_grey(0), 0);
  EXPECT_NEAR(of_grey(1), 0.2, 1e-6);
  EXPECT_EQ(of_grey(2), 1);
  const cv::Mat deep = (cv::Mat_<std::uint16_t>(2, 1) << 13107, 65535);
  const cv::Mat_<float> of_deep = pattern_of(of_file(folder.write("d.png", vo::encode_png(deep))));
  EXPECT_NEAR(of_deep(0, 0), 0.2, 1e-6);
  EXPECT_EQ(of_deep(1, 0), 1);
  const cv::Mat color(2, 3, CV_8UC3, cv::Scalar(0, 51, 102));
  const cv::Mat_<float> of_color =
      pattern_of(of_file(folder.write("c.png", vo::encode_png(color))));
  EXPECT_EQ(of_color.size(), cv::Size(3, 2));
  EXPECT_NEAR(of_color(1, 2), 0.2, 1e-6);
}

TEST(PatternFile, ThatCannotBeUsedIsNamedWithItsProjector) {
  const support::TempFolder folder;
  const auto refusal = [](const std::filesystem::path& path) {
    return error_text([&] { pattern_of(of_file(path)); });
  };
  EXPECT_THAT(
      refusal(folder.path() / "missing.png"),
      AllOf(HasSubstr("rig.toml:7: projector 'dots': pattern: "), HasSubstr("missing.png")));
  EXPECT_THAT(refusal(folder.write("broken.png", "no picture")),
              AllOf(HasSubstr("projector 'dots': pattern: "), HasSubstr("broken.png")));
  const std::string whole = vo::encode_png(cv::Mat(64, 64, CV_8UC1, cv::Scalar(7)));
  EXPECT_THAT(refusal(folder.write("cut.png", whole.substr(0, whole.size() / 2))),
              AllOf(HasSubstr("projector 'dots': pattern: "), HasSubstr("cut.png")));
  const cv::Mat wide(1025, 16384, CV_8UC1, cv::Scalar(0));
  EXPECT_THAT(refusal(folder.write("wide.png", vo::encode_png(wide))),
              HasSubstr("is 16384 x 1025 px, expected at most 16777216 pixels"));
}

}  // namespace
}  // namespace synth
