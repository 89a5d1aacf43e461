#include "synth/depth_sensor/depth_noise.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/depth_sensor/plane_view.h"

namespace synth {
namespace {

/// So long a lens that a plane has one incidence and, but for its lean, one depth.
vo::PinholeCamera long_lens() {
  return {.width = 200, .height = 200, .fx = 5e4, .fy = 5e4, .cx = 99.5, .cy = 99.5};
}

constexpr double kPixels = 200.0 * 200.0;
constexpr double kSpread = 4 / 282.0;  // four standard errors of a standard deviation, share

struct Statistics {
  double mean = 0;
  double deviation = 0;
};

Statistics errors(const vo::DepthImage& measured, const vo::DepthImage& exact) {
  double sum = 0;
  double squares = 0;
  for (int v = 0; v < exact.rows; ++v) {
    for (int u = 0; u < exact.cols; ++u) {
      const double error = static_cast<double>(measured(v, u)) - exact(v, u);
      sum += error;
      squares += error * error;
    }
  }
  const double mean = sum / kPixels;
  return {mean, std::sqrt(squares / kPixels - mean * mean)};
}

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

TEST(PlaneView, HasItsLeanAsIncidence) {
  const DepthView view = plane_view(long_lens(), 2, 40);
  EXPECT_NEAR(incidence(view, long_lens(), {100, 100}), radians(40), 1e-4);
  EXPECT_NEAR(view.depth(100, 100), 2, 1e-4);
}

TEST(AxialNoise, HasTheDeviationOfItsFormulaOverDepthAndIncidence) {
  const AxialNoise nguyen{
      .constant = 0.0012, .quadratic = 0.0019, .quadratic_from = 0.4, .grazing = 0.0001};
  for (const double z : {0.6, 1.5, 3.0}) {
    for (const double degrees : {0.0, 40.0, 70.0, 80.0}) {
      double expected = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
      if (degrees > 60) {
        const double slope = radians(degrees) / radians(90 - degrees);
        expected += 0.0001 / std::sqrt(z) * slope * slope;
      }
      const DepthView view = plane_view(long_lens(), z, degrees);
      const Statistics error = errors(with_axial_noise(view, long_lens(), nguyen, 3), view.depth);
      EXPECT_NEAR(error.deviation / expected, 1, kSpread + 0.02)
          << z << " m, " << degrees << " deg";
      EXPECT_NEAR(error.mean, 0, 4 * expected / 200);
    }
  }
}

TEST(AxialNoise, OfAzureKinectGrowsLinearlyFromHalfAMetre) {
  const AxialNoise azure{.constant = 0.0005, .linear = 0.001, .linear_from = 0.5};
  EXPECT_DOUBLE_EQ(axial_sigma(azure, 0.3, 0), 0.0005);
  EXPECT_DOUBLE_EQ(axial_sigma(azure, 2.5, 1), 0.0025);
}

TEST(AxialNoise, KeepsItsDeviationWhereNeighboursAreCorrelated) {
  const DepthView view = plane_view(long_lens(), 2, 0);
  const AxialNoise noise{.constant = 0.01, .correlation = 2};
  const vo::DepthImage measured = with_axial_noise(view, long_lens(), noise, 0);
  EXPECT_NEAR(errors(measured, view.depth).deviation, 0.01, 0.001);
  double product = 0;
  for (int v = 0; v < 200; ++v) {
    for (int u = 0; u < 198; ++u) {
      product += (measured(v, u) - 2.0) * (measured(v, u + 2) - 2.0);
    }
  }
  // White noise under a Gaussian of sigma has the correlation exp(-d^2 / (4 sigma^2)).
  EXPECT_NEAR(product / (200 * 198) / 1e-4, std::exp(-4.0 / 16), 0.12);
}

TEST(LateralNoise, HasTheSigmaOfItsFormula) {
  EXPECT_DOUBLE_EQ(lateral_sigma(0.8, 0.035, 0), 0.8);
  EXPECT_NEAR(lateral_sigma(0.8, 0.035, radians(45)), 0.835, 1e-12);
  EXPECT_NEAR(lateral_sigma(0.8, 0.035, radians(60)), 0.87, 1e-12);
}

TEST(LateralNoise, MovesAnEdgeByANormalNumber) {
  DepthView view = plane_view(long_lens(), 2, 0);
  view.depth.colRange(100, 200).setTo(1);
  const vo::DepthImage measured =
      with_lateral_noise(view, long_lens(), {.sigma = 1.5, .sampling = DepthSampling::nearest}, 0);
  for (int u = 96; u < 104; ++u) {
    const double near = 2 - cv::mean(measured.col(u))[0];
    const double expected = std::erfc((99.5 - u) / 1.5 / std::numbers::sqrt2) / 2;
    EXPECT_NEAR(near, expected, 4 * std::sqrt(expected * (1 - expected) / 200) + 1e-3) << u;
  }
}

TEST(LateralNoise, OnALeaningPlaneIsItsSlopeTimesSigma) {
  const vo::PinholeCamera camera = long_lens();
  const DepthView view = plane_view(camera, 2, 60);
  const vo::DepthImage measured =
      with_lateral_noise(view, camera, {.sigma = 0.7, .sampling = DepthSampling::linear}, 0);
  const double slope = 2 * std::tan(radians(60)) / camera.fx;  // m per px
  EXPECT_NEAR(errors(measured, view.depth).deviation / (0.7 * slope), 1, kSpread + 0.01);
}

TEST(NormalNoise, MovesASurfaceAlongItsNormal) {
  const vo::PinholeCamera camera = long_lens();
  for (const double degrees : {0.0, 50.0}) {
    const DepthView view = plane_view(camera, 3, degrees);
    const vo::DepthImage measured =
        with_normal_noise(view, camera, {.sigma = 0.8, .grazing = 0.035}, 0);
    const double sigma_m = lateral_sigma(0.8, 0.035, radians(degrees)) * 3 / camera.fx;
    EXPECT_NEAR(errors(measured, view.depth).deviation / (sigma_m * std::cos(radians(degrees))), 1,
                kSpread + 0.01);
  }
}

TEST(DisparityNoise, GrowsWithTheSquareOfDepth) {
  for (const double z : {1.0, 2.0, 4.0}) {
    const DepthView view = plane_view(long_lens(), z, 0);
    const Statistics error = errors(
        with_disparity_noise(view.depth, {.focal_baseline = 21.2, .sigma = 0.08}, 0), view.depth);
    EXPECT_NEAR(error.deviation / (0.08 * z * z / 21.2), 1, kSpread + 0.02) << z;
  }
}

TEST(DisparityNoise, LeavesWholeStepsOfDisparity) {
  const DisparityNoise primesense{.focal_baseline = 43.9125, .sigma = 1.0 / 48, .step = 0.125};
  const DepthView view = plane_view(long_lens(), 3, 0);
  const vo::DepthImage measured = with_disparity_noise(view.depth, primesense, 0);
  for (const float depth : measured) {
    const double steps = 43.9125 / depth / 0.125;
    ASSERT_NEAR(steps, std::round(steps), 1e-4);
  }
}

TEST(DisparityNoise, OfRedwoodIsTheFormulaOfItsPaper) {
  const DepthView view = plane_view(long_lens(), 2.2, 0);
  const vo::DepthImage measured =
      with_disparity_noise(view.depth, {.focal_baseline = 35.13, .step = 0.125}, 0);
  EXPECT_NEAR(measured(0, 0), 8 * 35.13 / std::round(8 * 35.13 / 2.2), 1e-6);
}

TEST(DepthNoise, LeavesHolesAlone) {
  DepthView view = plane_view(long_lens(), 2, 0);
  view.depth(5, 5) = 0;
  view.normal(5, 5) = {0, 0, 0};
  EXPECT_EQ(with_axial_noise(view, long_lens(), {.constant = 0.1}, 0)(5, 5), 0);
  EXPECT_EQ(with_lateral_noise(view, long_lens(), {.sigma = 1}, 0)(5, 5), 0);
  EXPECT_EQ(with_disparity_noise(view.depth, {.focal_baseline = 20, .sigma = 1}, 0)(5, 5), 0);
}

}  // namespace
}  // namespace synth
