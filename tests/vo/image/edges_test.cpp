#include "vo/image/edges.h"

#include <gtest/gtest.h>

#include "tests/support/textured_plane.h"
#include "vo/core/error.h"

namespace {

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

TEST(Edges, OptionsOutOfRangeAreErrors) {
  EXPECT_THROW(EdgeOptions{.percentile = 100}.validate(), vo::Error);
  EXPECT_THROW(EdgeOptions{.weak_ratio = 0}.validate(), vo::Error);
  EXPECT_NO_THROW(EdgeOptions{}.validate());
}

}  // namespace
