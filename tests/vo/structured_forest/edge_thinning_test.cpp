#include "vo/structured_forest/edge_thinning.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace {

/// A straight ridge through the middle of 41x41 px, 2 px wide, whose normal has this angle.
cv::Mat_<float> ridge(double angle) {
  cv::Mat_<float> image(41, 41);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const double distance = (u - 20) * std::cos(angle) + (v - 20) * std::sin(angle);
      image(v, u) = static_cast<float>(std::exp(-distance * distance / 8));
    }
  }
  return image;
}

TEST(AcrossRidges, IsTheNormalOfAStraightRidge) {
  for (const double degrees : {0.0, 20.0, 45.0, 90.0, 115.0, 170.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const cv::Vec2f across = vo::across_ridges(ridge(angle), 2)(20, 20);
    const double cosine = across[0] * std::cos(angle) + across[1] * std::sin(angle);
    EXPECT_GT(std::abs(cosine), std::cos(2 * std::numbers::pi / 180)) << degrees << " deg";
  }
}

TEST(Thinned, OfAnUprightRidgeKeepsTheCrestAlone) {
  const cv::Mat_<float> strength = ridge(0);
  const cv::Mat_<float> thin = vo::thinned(strength, vo::across_ridges(strength, 2), 2);
  for (int v = 0; v < thin.rows; ++v) {
    EXPECT_EQ(cv::countNonZero(thin.row(v).colRange(10, 31)), 1) << "row " << v;
    EXPECT_EQ(thin(v, 20), strength(v, 20));
  }
}

TEST(Thinned, OfTwoEqualNeighboursKeepsOne) {
  cv::Mat_<float> strength(1, 6, 0.0F);
  strength(0, 2) = strength(0, 3) = 1;
  const vo::GradientImage across(1, 6, cv::Vec2f(1, 0));
  EXPECT_EQ(cv::countNonZero(vo::thinned(strength, across, 1)), 1);
}

}  // namespace
