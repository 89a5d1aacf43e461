#include "vo/edges/edges.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/core/error.h"

namespace {

using vo::EdgeDetector;
using vo::EdgeOptions;
using vo::EdgeThreshold;

/// Dark left of column 20, bright from it on.
vo::GrayImage step(float contrast) {
  vo::GrayImage image(40, 40, 0.5F);
  image.colRange(20, 40) = 0.5F + contrast;
  return image;
}

int edge_pixels(const vo::GrayImage& image, const EdgeOptions& options) {
  return cv::countNonZero(vo::detect_edges(image, options));
}

vo::GrayImage textured(double contrast) {
  const vo::RgbdFrame frame = support::TexturedPlane().render(support::small_camera(), {});
  vo::GrayImage image;
  vo::to_gray(frame.image).convertTo(image, CV_32F, contrast);
  return image;
}

/// Both columns beside the step have the same gradient; Canny keeps one of them.
TEST(Edges, OfAStepAreOneColumnBesideTheStep) {
  for (const EdgeThreshold threshold : {EdgeThreshold::percentile, EdgeThreshold::fixed}) {
    const vo::EdgeMask edges =
        vo::detect_edges(step(0.3F), {.threshold = threshold, .percentile = 94});
    for (int v = 2; v < 38; ++v) {
      EXPECT_EQ(cv::countNonZero(edges.row(v)), 1) << "row " << v;
      EXPECT_NE(edges(v, 19) + edges(v, 20), 0) << "row " << v;
    }
  }
}

TEST(Edges, PercentileDoesNotDependOnContrast) {
  const EdgeOptions options{.threshold = EdgeThreshold::percentile};
  const int full = edge_pixels(textured(1.0), options);
  const int faint = edge_pixels(textured(0.5), options);
  EXPECT_GT(full, 2000);
  EXPECT_NEAR(faint, full, 0.03 * full);
}

TEST(Edges, AHigherPercentileGivesFewerEdges) {
  EXPECT_LT(edge_pixels(textured(1), {.percentile = 95}),
            edge_pixels(textured(1), {.percentile = 80}));
}

TEST(Edges, NoiseOfOneGreyLevelHasNone) {
  vo::GrayImage image(60, 60);
  for (int i = 0; i < 3600; ++i) {
    image(i / 60, i % 60) = 0.5F + static_cast<float>((i * 7919) % 2) / 255;
  }
  EXPECT_EQ(edge_pixels(image, {}), 0);
}

/// Sobel magnitudes of whole intensities, counted anew.
int pixels_at_or_above(const vo::GrayImage& image, double magnitude) {
  return edge_pixels(image, {.detector = EdgeDetector::sobel,
                             .threshold = EdgeThreshold::fixed,
                             .strong = magnitude,
                             .sobel_thin = false});
}

TEST(Edges, TargetCountIsReachedAsNearlyAsWholeMagnitudesAllow) {
  const vo::GrayImage image = textured(1);
  for (const int target : {500, 3000, 10000}) {
    const EdgeOptions options{.detector = EdgeDetector::sobel,
                              .threshold = EdgeThreshold::target_count,
                              .target_count = target,
                              .sobel_thin = false};
    const int found = edge_pixels(image, options);
    EXPECT_LE(found, target);
    double magnitude = 20;
    while (pixels_at_or_above(image, magnitude) > target) {
      ++magnitude;
    }
    EXPECT_EQ(found, pixels_at_or_above(image, magnitude));
  }
}

TEST(Edges, SobelOfAStepAreBothColumnsBesideItAndOneWhenThin) {
  EdgeOptions options{
      .detector = EdgeDetector::sobel, .threshold = EdgeThreshold::fixed, .sobel_thin = false};
  EXPECT_EQ(edge_pixels(step(0.3F), options), 2 * 40);
  options.sobel_thin = true;
  EXPECT_EQ(edge_pixels(step(0.3F), options), 40);
}

/// At the edge the smoothed Laplacian has the slope c / (sqrt(2 pi) sigma^3).
TEST(Edges, LogOfAStepIsOneColumnUpToItsSlope) {
  constexpr double kSigma = 3;
  const double slope = 0.3 * 255 / (std::sqrt(2 * std::numbers::pi) * std::pow(kSigma, 3));
  EdgeOptions options{.detector = EdgeDetector::log, .log_sigma = kSigma};
  options.log_strength = 0.9 * slope;
  const vo::EdgeMask edges = vo::detect_edges(step(0.3F), options);
  EXPECT_EQ(cv::countNonZero(edges), 40);
  EXPECT_EQ(cv::countNonZero(edges.colRange(19, 21)), 40);
  options.log_strength = 1.1 * slope;
  EXPECT_EQ(edge_pixels(step(0.3F), options), 0);
}

TEST(Edges, AForestNeedsAModel) {
  EXPECT_THROW(EdgeOptions{.detector = EdgeDetector::structured_forest}.validate(), vo::Error);
  EXPECT_THROW(vo::EdgeFinder({.detector = EdgeDetector::structured_forest,
                               .forest_model = "no/such/model.yml.gz"}),
               vo::Error);
}

TEST(Edges, OptionsOutOfRangeAreErrors) {
  EXPECT_THROW(EdgeOptions{.percentile = 100}.validate(), vo::Error);
  EXPECT_THROW(EdgeOptions{.weak_ratio = 0}.validate(), vo::Error);
  EXPECT_NO_THROW(EdgeOptions{}.validate());
}

}  // namespace
