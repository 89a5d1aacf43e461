#include "tools/pictures/frame_gallery.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/plane_report.h"

namespace {

std::size_t bytes_of(const std::vector<tools::FramePictures>& pictures) {
  return std::transform_reduce(pictures.begin(), pictures.end(), std::size_t{0}, std::plus<>(),
                               [](const tools::FramePictures& p) { return p.bytes(); });
}

bool is_webp(const std::string& bytes) {
  return bytes.substr(0, 4) == "RIFF" && bytes.substr(8, 4) == "WEBP";
}

TEST(FrameGallery, KeepsEveryFrameWhileTheyFit) {
  const tools::ScenarioReport report = support::plane_report(5, 5);
  EXPECT_EQ(report.gallery.stride(), 1U);
  ASSERT_EQ(report.gallery.pictures().size(), 5U);
  EXPECT_EQ(report.gallery.views().size(), 5U);
  const tools::FramePictures& pictures = report.gallery.pictures()[3];
  EXPECT_EQ(pictures.size, cv::Size(160, 120));
  for (const std::string* bytes : {&pictures.colour, &pictures.edges, &pictures.depth.webp,
                                   &pictures.residual_before, &pictures.residual_after}) {
    EXPECT_TRUE(is_webp(*bytes));
  }
  EXPECT_GT(pictures.depth.range[0], pictures.depth.range[1]) << "far is dark";
  EXPECT_EQ(report.gallery.pictures()[0].residual_after, "") << "the first frame has no reference";
}

TEST(FrameGallery, ThinsOutEvenlyToItsLimit) {
  constexpr std::size_t kLimit = 30000;
  const tools::ScenarioReport report = support::plane_report(20, 20, {.max_bytes = kLimit});
  const auto& pictures = report.gallery.pictures();
  const std::size_t stride = report.gallery.stride();
  EXPECT_GT(stride, 1U);
  EXPECT_LE(bytes_of(pictures), kLimit);
  EXPECT_EQ(pictures.size(), (20 + stride - 1) / stride);
  EXPECT_EQ(report.gallery.views().size(), pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_EQ(pictures[i].timestamp, report.frames[i * stride].timestamp);
  }
}

TEST(FrameGallery, PicturesOfALargeImageAreOfTheLevelThatFits) {
  const tools::ScenarioReport report = support::plane_report(2, 2, {.max_width = 100});
  EXPECT_EQ(report.gallery.pictures()[1].size, cv::Size(80, 60));
}

TEST(FrameGallery, InverseDepthLiesBesideTheTruthInItsRange) {
  tools::ScenarioReport report = support::plane_report(2, 2);
  vo::DepthImage truth(120, 160, 2.0F);
  truth(0, 0) = 4;
  const vo::DepthImage estimate(120, 160, 4.0F);
  report.gallery.add_inverse_depth(report.frames[1].timestamp, estimate, truth);
  report.gallery.add_inverse_depth(99, estimate, truth);
  const tools::FramePictures& pictures = report.gallery.pictures()[1];
  EXPECT_THAT(pictures.inverse_depth.range, testing::ElementsAre(0.25, 0.5));
  EXPECT_EQ(pictures.inverse_depth_truth.range, pictures.inverse_depth.range);
  EXPECT_TRUE(is_webp(pictures.inverse_depth.webp));
  EXPECT_EQ(report.gallery.pictures()[0].inverse_depth.webp, "");
}

}  // namespace
