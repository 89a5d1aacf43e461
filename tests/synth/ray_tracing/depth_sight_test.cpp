#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/ray_tracing/depth_sight_tracer.h"
#include "synth/ray_tracing/ray_tracer.h"
#include "tests/support/quads.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const cv::Point kOnAxis(32, 24);

Material pane() {
  Material material = diffuse({1, 1, 1});
  material.specular = 1;
  material.roughness = 0;
  material.layers.transmission = 1;
  return material;
}

Material metal(float base_color, float roughness) {
  Material material = diffuse(Vector3f::Constant(base_color));
  material.metallic = 1;
  material.roughness = roughness;
  return material;
}

/// A wall that leans, behind the square that the camera sees through or at its side.
Mesh leaning_wall() {
  return quad({-3, -3, 2}, {6, 0, 1}, {0, 6, 0.5F});
}

/// Returns the sight, depth and normals of a depth camera that stands still.
RenderedFrame sight_of(const Scene& scene, SolidGlass solids = SolidGlass::straight) {
  const vo::PinholeCamera camera = wide_camera();
  Capture capture = still(camera, {});
  capture.solids = solids;
  capture.channels = {.color = false, .depth = true, .normal = true, .sight = true};
  return make_ray_tracer(scene, {.mode = RenderMode::depth})->render(capture);
}

std::uint8_t kind(FirstSurface first) {
  return static_cast<std::uint8_t>(first);
}

/// Expects beyond every pixel of a kind what a second scene shows there directly.
void expect_beyond(const RenderedFrame& frame, FirstSurface first, const RenderedFrame& direct) {
  int count = 0;
  for (int v = 0; v < frame.depth.rows; ++v) {
    for (int u = 0; u < frame.depth.cols; ++u) {
      if (frame.sight.first(v, u) == kind(first)) {
        ++count;
        EXPECT_NEAR(frame.sight.beyond(v, u), direct.depth(v, u), 2e-6) << u << ", " << v;
        EXPECT_LT(cv::norm(frame.sight.beyond_normal(v, u), direct.normal(v, u)), 1e-5)
            << u << ", " << v;
      } else {
        EXPECT_EQ(frame.sight.beyond(v, u), frame.depth(v, u)) << "opaque, or nothing";
      }
    }
  }
  EXPECT_GT(count, 100);
}

TEST(DepthSight, BehindGlassIsWhatTheCameraSeesWithoutIt) {
  Scene without;
  add(without, leaning_wall(), diffuse({1, 1, 1}));
  Scene scene = without;
  add(scene, square_at(1, 0.4F), pane());
  add(scene, square_at(1.01F, 0.4F), pane());  // the other side of the pane
  const RenderedFrame frame = sight_of(scene);
  EXPECT_NEAR(frame.depth(kOnAxis), 1, 1e-6) << "the first surface stays the depth";
  expect_beyond(frame, FirstSurface::glass, sight_of(without));
}

/// A plane of a mirror that turns the optical axis aside, through a point of the axis.
struct MirrorPlane {
  Vector3d normal;
  Vector3d point;

  Vector3d image(const Vector3d& p) const { return p - 2 * normal.dot(p - point) * normal; }

  Mesh image(Mesh mesh) const {
    for (Vector3f& position : mesh.positions) {
      position = image(Vector3d(position.cast<double>())).cast<float>();
    }
    return mesh;
  }
};

const MirrorPlane kTurned{Vector3d(-1, 0, -1).normalized(), {0, 0, 1.5}};  // shows what is at -x

/// A wall at the side that the camera sees in the mirror alone.
Mesh side_wall() {
  return quad({-2, -2, -0.5F}, {-0.5F, 0, 3}, {0, 4, 0});
}

TEST(DepthSight, InAMirrorIsWhatStandsBehindItsPlaneMirrored) {
  Scene scene;
  add(scene, quad({0.5F, -0.6F, 1}, {-1, 0, 1}, {0, 1.2F, 0}), metal(0.9F, 0.05F));
  add(scene, side_wall(), diffuse({1, 1, 1}));
  Scene mirrored;
  add(mirrored, kTurned.image(side_wall()), diffuse({1, 1, 1}));
  const RenderedFrame frame = sight_of(scene);
  EXPECT_EQ(frame.sight.first(kOnAxis), kind(FirstSurface::mirror));
  EXPECT_GT(frame.sight.beyond(kOnAxis), 3.4) << "1.5 m to the mirror, 2 m to the wall";
  int count = 0;
  const RenderedFrame expected = sight_of(mirrored);
  for (int v = 0; v < frame.depth.rows; ++v) {
    for (int u = 0; u < frame.depth.cols; ++u) {
      if (frame.sight.first(v, u) == kind(FirstSurface::mirror)) {
        ++count;
        EXPECT_NEAR(frame.sight.beyond(v, u), expected.depth(v, u), 5e-6) << u << ", " << v;
        EXPECT_LT(cv::norm(frame.sight.beyond_normal(v, u), expected.normal(v, u)), 1e-5);
      }
    }
  }
  EXPECT_GT(count, 300);
}

TEST(DepthSight, GoesOnBehindGlassInAMirrorByAnotherMirror) {
  const MirrorPlane back{Vector3d(1, 0, 1).normalized(), {-1, 0, 1.5}};  // sends -x on to +z
  const Mesh wall = square_at(4, 3);
  Scene scene;
  add(scene, quad({0.3F, -0.5F, 1.2F}, {-0.6F, 0, 0.6F}, {0, 1, 0}), metal(1, 0));
  add(scene, quad({-0.5F, -1, 1}, {-1, 0, 1}, {0, 2, 0}), metal(1, 0));
  add(scene, quad({-0.6F, -1, 1}, {0, 0, 1}, {0, 2, 0}), pane());  // between the mirrors
  add(scene, wall, diffuse({1, 1, 1}));
  Scene unfolded;
  add(unfolded, kTurned.image(back.image(wall)), diffuse({1, 1, 1}));
  const RenderedFrame frame = sight_of(scene);
  ASSERT_EQ(frame.sight.first(kOnAxis), kind(FirstSurface::mirror));
  EXPECT_NEAR(frame.sight.beyond(kOnAxis), sight_of(unfolded).depth(kOnAxis), 5e-6);
  const float passed = 0.96F / 1.04F;  // of a thin wall, at the incidence 0
  const float length = frame.sight.beyond(kOnAxis);
  EXPECT_NEAR(frame.sight.beyond_returned(kOnAxis), passed * passed / (length * length), 1e-5);
}

TEST(DepthSight, ReturnsLightByTheCosineAndTheSquareOfTheDistance) {
  Scene scene;
  add(scene, leaning_wall(), diffuse({0.3F, 0.5F, 0.7F}));
  const RenderedFrame frame = sight_of(scene);
  const vo::PinholeCamera camera = wide_camera();
  for (const cv::Point pixel : {kOnAxis, cv::Point(3, 40), cv::Point(60, 5)}) {
    const Vector3d ray = camera.unproject({pixel.x, pixel.y}, 1);
    const cv::Vec3f n = frame.normal(pixel);
    const double cosine = -Vector3d(n[0], n[1], n[2]).dot(ray.normalized());
    const double distance = frame.depth(pixel) * ray.norm();
    EXPECT_NEAR(frame.sight.returned(pixel), 0.5 * cosine / (distance * distance), 1e-5);
    EXPECT_EQ(frame.sight.beyond_returned(pixel), frame.sight.returned(pixel));
  }
}

/// Head-on GGX's lobe is D F / 4 with D = 1 / (pi alpha^2); far aside it is gone.
TEST(DepthSight, OfAMetalComesBackStraightAheadAlone) {
  Scene scene;
  add(scene, square_at(1, 6), metal(0.6F, 0.5F));
  const RenderedFrame frame = sight_of(scene);
  EXPECT_EQ(frame.sight.first(kOnAxis), kind(FirstSurface::opaque)) << "rough";
  EXPECT_NEAR(frame.sight.returned(kOnAxis), 0.6 / (4 * std::pow(0.25, 2)), 1e-3);
  EXPECT_LT(frame.sight.returned(kOnAxis.y, 0), 0.03) << "at 45 degrees";
}

TEST(DepthSight, EndsWhereNothingIsAndAmongMirrorsWithoutEnd) {
  Scene scene;
  add(scene, square_at(2, 0.5F), pane());
  EXPECT_EQ(sight_of(scene).sight.beyond(kOnAxis), 0) << "nothing behind the glass";
  Scene mirrors;
  add(mirrors, square_at(1, 5), metal(1, 0));
  add(mirrors, square_at(-1, 5), metal(1, 0));
  const RenderedFrame frame = sight_of(mirrors);
  EXPECT_EQ(frame.sight.first(kOnAxis), kind(FirstSurface::mirror));
  EXPECT_NEAR(frame.sight.beyond(kOnAxis), 1 + 16 * 2, 1e-3) << "the seventeenth counts as opaque";
}

Material solid_glass(double ior) {
  Material material = pane();
  material.layers.is_solid = true;
  material.ior = static_cast<float>(ior);
  return material;
}

/// Between planes of a slab z and z + t, of n times the path that a ray at the cosine c takes to a
/// wall across the axis at Z, the depth is Z - t + n t c / c', with Snell's s' = s / n.
TEST(DepthSight, ThroughASlabIsTheOpticalPathOfTheClosedForm) {
  constexpr double kIor = 1.6;
  constexpr float kThickness = 0.4F;
  Scene scene;  // the slab's fronts are outside
  add(scene, quad({9, -9, 1}, {-18, 0, 0}, {0, 18, 0}), solid_glass(kIor));
  add(scene, quad({-9, -9, 1 + kThickness}, {18, 0, 0}, {0, 18, 0}), solid_glass(kIor));
  add(scene, square_at(2.5, 9), diffuse({1, 1, 1}));
  const RenderedFrame bent = sight_of(scene, SolidGlass::refracted);
  const RenderedFrame straight = sight_of(scene);
  for (const cv::Point pixel : {kOnAxis, cv::Point(0, 0), cv::Point(50, 10), cv::Point(3, 45)}) {
    const double cosine = 1 / wide_camera().unproject({pixel.x, pixel.y}, 1).norm();
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (kIor * kIor));
    EXPECT_NEAR(bent.sight.beyond(pixel), 2.5 + 0.4 * (kIor * cosine / inside - 1), 2e-6);
    EXPECT_LT(cv::norm(bent.sight.beyond_normal(pixel), cv::Vec3f(0, 0, -1)), 1e-5);
    EXPECT_NEAR(straight.sight.beyond(pixel), 2.5, 2e-6);
  }
  const float passed = 1 - std::pow(0.6F / 2.6F, 2.0F);  // of one face, at the incidence 0
  const double reduced = 1 + kThickness / kIor + (2.5 - 1 - kThickness);
  EXPECT_NEAR(bent.sight.beyond_returned(kOnAxis), std::pow(passed, 4.0F) / (reduced * reduced),
              1e-5);
}

/// Rays of light leave glass into n^2 times the solid angle that they have in it.
TEST(DepthSight, OfAWallInsideASolidReturnsLessLightByTheSquareOfTheIndex) {
  constexpr double kIor = 1.6;
  Scene scene;
  add(scene, quad({9, -9, 1}, {-18, 0, 0}, {0, 18, 0}), solid_glass(kIor));
  add(scene, square_at(1.5F, 9), diffuse({1, 1, 1}));
  const RenderedFrame bent = sight_of(scene, SolidGlass::refracted);
  const double passed = 1 - std::pow(0.6 / 2.6, 2);
  EXPECT_NEAR(bent.sight.beyond_returned(kOnAxis), std::pow(passed / (kIor * (1 + 0.5 / kIor)), 2),
              1e-5);
}

/// A right-angled prism turns the axis by total reflection at its long side, and shows what is at
/// the side where it would be straight ahead.
TEST(DepthSight, InAPrismIsReflectedInsideBeyondTheCriticalAngle) {
  constexpr double kIor = 1.5;
  Scene scene;  // from (x, z) = (-0.5, 1) to (0.5, 1) and (0.5, 2); the long side faces -x, +z
  add(scene, quad({0.5F, -1, 1}, {-1, 0, 0}, {0, 2, 0}), solid_glass(kIor));
  add(scene, quad({-0.5F, -1, 1}, {1, 0, 1}, {0, 2, 0}), solid_glass(kIor));
  add(scene, quad({0.5F, -1, 2}, {0, 0, -1}, {0, 2, 0}), solid_glass(kIor));
  add(scene, quad({2, -1, 2}, {0, 0, -1}, {0, 2, 0}), diffuse({1, 1, 1}));
  add(scene, square_at(5, 9), diffuse({1, 1, 1}));
  const RenderedFrame bent = sight_of(scene, SolidGlass::refracted);
  EXPECT_NEAR(bent.sight.beyond(kOnAxis), 1 + kIor * 1 + 1.5, 5e-6);
  EXPECT_LT(cv::norm(bent.sight.beyond_normal(kOnAxis), cv::Vec3f(0, 0, -1)), 1e-5);
  EXPECT_NEAR(sight_of(scene).sight.beyond(kOnAxis), 5, 5e-6) << "straight through it";
}

TEST(DepthSight, LooksForMaterialsThatMayBeClear) {
  Scene scene;
  add(scene, square_at(1, 1), diffuse({1, 1, 1}));
  add(scene, square_at(1, 1), metal(1, 0.5F));
  EXPECT_FALSE(may_show_clear_surfaces(scene));
  scene.materials.back().metallic_roughness_texture.texture = 0;
  EXPECT_TRUE(may_show_clear_surfaces(scene)) << "the texture may make it smooth";
  Scene window;
  add(window, square_at(1, 1), pane());
  EXPECT_TRUE(may_show_clear_surfaces(window));
}

}  // namespace
}  // namespace synth
