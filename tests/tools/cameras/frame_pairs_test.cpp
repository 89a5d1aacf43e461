#include "tools/cameras/frame_pairs.h"

#include <vector>

#include <gtest/gtest.h>

namespace {

constexpr double kPeriod = 1.0 / 30;  // s

cv::Mat image(int index) {
  return cv::Mat(2, 3, CV_8UC3, cv::Scalar::all(index));
}

vo::DepthImage depth(int index) {
  return vo::DepthImage(2, 3, static_cast<float>(index));
}

TEST(FramePairs, ImagesOfOneStampAreAFrameInEitherOrder) {
  tools::FramePairs pairs(0.02);
  for (int i = 0; i < 4; ++i) {
    if (i % 2 == 0) {
      pairs.add_colour(i * kPeriod, image(i));
      EXPECT_FALSE(pairs.take());
      pairs.add_depth(i * kPeriod, depth(i));
    } else {
      pairs.add_depth(i * kPeriod, depth(i));
      EXPECT_FALSE(pairs.take());
      pairs.add_colour(i * kPeriod, image(i));
    }
    const auto frame = pairs.take();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->timestamp, i * kPeriod);
    EXPECT_EQ(frame->image.at<cv::Vec3b>(1, 2)[0], i);
    EXPECT_EQ(frame->depth(1, 2), static_cast<float>(i));
  }
  EXPECT_EQ(pairs.unpaired(), 0U);
}

TEST(FramePairs, AnImageThatIsMissingCostsItsFrameAlone) {
  for (const bool is_colour_missing : {true, false}) {
    tools::FramePairs pairs(0.01);
    std::vector<double> stamps;
    for (int i = 0; i < 6; ++i) {
      if (i != 2 || is_colour_missing) {
        pairs.add_depth(i * kPeriod, depth(i));
      }
      if (i != 2 || !is_colour_missing) {
        pairs.add_colour(i * kPeriod, image(i));
      }
      if (const auto frame = pairs.take()) {
        stamps.push_back(frame->timestamp);
      }
    }
    EXPECT_EQ(stamps, (std::vector{0.0, kPeriod, 3 * kPeriod, 4 * kPeriod, 5 * kPeriod}));
    EXPECT_EQ(pairs.unpaired(), 1U);
  }
}

TEST(FramePairs, OfTwoThatAreTooFarApartTheOlderIsGivenUp) {
  tools::FramePairs pairs(0.01);
  pairs.add_colour(1, image(1));
  pairs.add_depth(1.5, depth(2));
  EXPECT_FALSE(pairs.take());
  pairs.add_colour(1.495, image(3));
  const auto frame = pairs.take();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->timestamp, 1.495) << "the stamp of its colour";
  EXPECT_EQ(frame->depth(0, 0), 2);
  EXPECT_EQ(pairs.unpaired(), 1U);
}

}  // namespace
