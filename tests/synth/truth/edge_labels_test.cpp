#include "synth/truth/edge_labels.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/quads.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const Vector3f kGrey = Vector3f::Constant(0.5F);

/// Seen by a camera at the world's origin that looks along z, 65x49 px, 32 px per unit of x / z;
/// pixel (32, 24) is the middle.
EdgeLabels labels_of(const Scene& scene) {
  return edge_labels(SurfaceTracer(scene, 0.3).trace(wide_camera(), {}), wide_camera(), {});
}

int count(const EdgeLabels& labels, int cause) {
  return cv::countNonZero(labels & cause);
}

TEST(EdgeLabels, OfASlantedPlaneAreNone) {
  Scene scene;
  add(scene, quad({-16, -16, 0.7F}, {32, 0, 0}, {0, 32, 8}), diffuse(kGrey));
  scene.lights = {point_light({0, 0, 0}, Vector3f::Ones())};
  const EdgeLabels labels = labels_of(scene);
  EXPECT_EQ(cv::countNonZero(labels.rowRange(14, 35)), 0);
}

/// The square covers |x|, |y| <= 0.52 at depth 1, hence 16 px to each side of the middle.
TEST(EdgeLabels, OfASquareBeforeAWallAreItsOutermostPixels) {
  Scene scene;
  add(scene, square_at(4, 20), unlit(kGrey));
  add(scene, square_at(1, 0.52F), unlit(kGrey));
  const EdgeLabels labels = labels_of(scene);
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      const int distance = std::max(std::abs(u - 32), std::abs(v - 24));
      EXPECT_EQ(labels(v, u), distance == 16 ? bit(EdgeCause::depth) : 0) << u << ", " << v;
    }
  }
}

TEST(EdgeLabels, WhereNothingIsBehindTheLastSurfaceEnds) {
  Scene scene;
  add(scene, square_at(1, 0.52F), unlit(kGrey));
  EXPECT_EQ(count(labels_of(scene), bit(EdgeCause::depth)), 4 * 32);
}

/// Two walls that meet at x = 0, each 45 degrees off the view, and the same nearly world.
TEST(EdgeLabels, OfACornerAreACreaseIfItIsSharp) {
  for (const auto& [slope, has_crease] : {std::pair{1.0F, true}, std::pair{0.1F, false}}) {
    Scene scene;
    add(scene, quad({0.01F, -8, 4}, {-8, 0, -8 * slope}, {0, 16, 0}), unlit(kGrey));
    add(scene, quad({0.01F, -8, 4}, {8, 0, -8 * slope}, {0, 16, 0}), unlit(kGrey));
    const EdgeLabels labels = labels_of(scene);
    EXPECT_EQ(count(labels, bit(EdgeCause::crease)), has_crease ? labels.rows : 0);
    EXPECT_EQ(count(labels.col(32), bit(EdgeCause::crease)), has_crease ? labels.rows : 0);
    EXPECT_EQ(count(labels, bit(EdgeCause::depth)), 0);
  }
}

TEST(EdgeLabels, OfTwoColoursInOnePlaneAreOneColumn) {
  for (const auto& [other, has_edge] : {std::pair{0.9F, true}, std::pair{0.52F, false}}) {
    Scene scene;
    add(scene, quad({-8, -8, 2}, {8.01F, 0, 0}, {0, 16, 0}), unlit(kGrey));
    add(scene, quad({0.01F, -8, 2}, {8, 0, 0}, {0, 16, 0}), unlit(Vector3f::Constant(other)));
    const EdgeLabels labels = labels_of(scene);
    EXPECT_EQ(cv::countNonZero(labels), has_edge ? labels.rows : 0);
    EXPECT_EQ(count(labels.col(32), bit(EdgeCause::albedo)), has_edge ? labels.rows : 0);
  }
}

/// A light at x = -1 throws the shadow of a square at depth 1, 0.4 m wide, on a wall at depth 4:
/// four times as wide, x from -1.8 to -0.2 and y from -0.8 to 0.8, 8 px a metre.
TEST(EdgeLabels, OfAShadowAreItsBorder) {
  Scene scene;
  add(scene, square_at(4, 20), diffuse(kGrey));
  add(scene, quad({-1.2F, -0.2F, 1}, {0.4F, 0, 0}, {0, 0.4F, 0}), diffuse(kGrey));
  scene.lights = {point_light({-1, 0, 0}, Vector3f::Ones())};
  const EdgeLabels labels = labels_of(scene);
  const auto is_dark = [](int u, int v) { return u >= 18 && u <= 30 && v >= 18 && v <= 30; };
  for (int v = 0; v + 1 < labels.rows; ++v) {
    for (int u = 10; u + 1 < labels.cols; ++u) {  // left of it is the square itself
      const bool has_edge =
          is_dark(u, v) != is_dark(u + 1, v) || is_dark(u, v) != is_dark(u, v + 1);
      EXPECT_EQ(labels(v, u), has_edge ? bit(EdgeCause::shadow) : 0) << u << ", " << v;
    }
  }
}

TEST(EdgeLabels, StepsMustBeAboveZero) {
  EXPECT_NO_THROW(EdgeLabelOptions{}.validate());
  EXPECT_THROW(EdgeLabelOptions{.depth_step = 0}.validate(), vo::Error);
  EXPECT_THROW(EdgeLabelOptions{.crease_deg = 180}.validate(), vo::Error);
}

}  // namespace
}  // namespace synth
