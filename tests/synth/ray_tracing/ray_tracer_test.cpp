#include "synth/ray_tracing/ray_tracer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tests/support/quads.h"
#include "vo/geometry/se3.h"

namespace synth {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kRounding = 1e-6;  // m, of a float of a few metres
const RenderOptions kOneSample{.samples = 1};

vo::PinholeCamera distorted_camera() {
  vo::PinholeCamera camera = wide_camera();
  camera.distortion = {.k1 = 0.2, .k2 = -0.05, .p1 = 0.003, .p2 = -0.002, .k3 = 0.01};
  return camera;
}

/// The greatest error over all pixels, m, against a depth along camera.unproject(pixel, 1).
double max_depth_error(const RenderedFrame& frame, const vo::PinholeCamera& camera,
                       const std::function<double(const Vector3d&)>& depth_along) {
  double worst = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double expected = depth_along(camera.unproject(Vector2d(u, v), 1));
      worst = std::max(worst, std::abs(frame.depth(v, u) - expected));
    }
  }
  return worst;
}

/// Through (0, 0, 2), leaning so that its depth is nowhere symmetric.
Scene tilted_plane() {
  Scene scene;
  add(scene, quad({-16, -16, -2}, {32, 0, 8}, {0, 32, 0}), unlit(Vector3f::Ones()));
  return scene;
}

double depth_of_tilted_plane(const Vector3d& ray) {
  const Vector3d normal(-0.25, 0, 1);
  return 2 / normal.dot(ray);
}

/// 20 px a radian: its corners are 115 deg off the axis, where it sees nothing.
TEST(RayTracer, DepthThroughAFisheyeIsExactAndNoneBeyondWhatItSees) {
  vo::PinholeCamera camera = wide_camera();
  camera.fx = camera.fy = 20;
  camera.distortion = {.k1 = -0.01, .k2 = 0.003, .model = vo::DistortionModel::kannala_brandt};
  Scene scene;
  add(scene, square_at(2, 100), unlit(Vector3f::Ones()));
  const RenderedFrame frame = render(scene, kOneSample, camera);
  int unseen = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const bool is_seen = camera.unproject(Vector2d(u, v), 1).allFinite();
      EXPECT_NEAR(frame.depth(v, u), is_seen ? 2 : 0, kRounding) << u << " " << v;
      EXPECT_EQ(frame.radiance(v, u)[0], is_seen ? 1 : 0) << u << " " << v;
      unseen += is_seen ? 0 : 1;
    }
  }
  EXPECT_GT(unseen, 50);
  EXPECT_LT(unseen, 1000);
}

TEST(RayTracer, DepthOfATiltedPlaneIsExact) {
  const RenderedFrame frame = render(tilted_plane(), kOneSample);
  EXPECT_LT(max_depth_error(frame, wide_camera(), depth_of_tilted_plane), kRounding);
}

TEST(RayTracer, DepthIsExactThroughADistortedLens) {
  const RenderedFrame frame = render(tilted_plane(), kOneSample, distorted_camera());
  EXPECT_LT(max_depth_error(frame, distorted_camera(), depth_of_tilted_plane), kRounding);
}

TEST(RayTracer, DepthIsExactInAFrameWithYUp) {
  vo::PinholeCamera camera = wide_camera();
  camera.fy = -camera.fy;
  const RenderedFrame frame = render(tilted_plane(), kOneSample, camera);
  EXPECT_LT(max_depth_error(frame, camera, depth_of_tilted_plane), kRounding);
}

TEST(RayTracer, DepthDoesNotDependOnWhereTheSceneStands) {
  const vo::SE3 T_world_scene(Eigen::Quaterniond(0.5, -0.2, 0.7, 0.1), Vector3d(3e5, -40, 5e6));
  Scene scene = tilted_plane();
  scene.instances[0].T_world_mesh =
      Eigen::Translation3d(T_world_scene.translation()) * T_world_scene.rotation();
  const RenderedFrame frame = render(scene, kOneSample, wide_camera(), T_world_scene);
  constexpr double kDoubleRounding = 1e-8;  // m, at 5e6 m
  EXPECT_LT(max_depth_error(frame, wide_camera(), depth_of_tilted_plane),
            kRounding + kDoubleRounding);
}

TEST(RayTracer, MirroredAndStretchedInstancesAreWhereTheirVerticesAre) {
  Scene scene = tilted_plane();
  scene.instances[0].T_world_mesh = Eigen::Scaling(Vector3d(-1, 1, 1.5));
  const RenderedFrame frame = render(scene, kOneSample);
  const auto depth_along = [](const Vector3d& ray) { return 3 / (1 + 0.375 * ray.x()); };
  EXPECT_LT(max_depth_error(frame, wide_camera(), depth_along), kRounding);
}

/// Returns whether a pixel lies inside a convex polygon, clockwise in the image; by how many px.
double inside_by(const std::vector<Vector2d>& polygon, const Vector2d& pixel) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const Vector2d to_pixel = pixel - polygon[i];
    least = std::min(least, (edge.x() * to_pixel.y() - edge.y() * to_pixel.x()) / edge.norm());
  }
  return least;
}

TEST(RayTracer, AQuadCoversThePixelsBetweenItsProjectedCorners) {
  Scene scene;
  add(scene, quad({-0.9F, -0.6F, 1.3F}, {1.5F, 0.2F, 0.9F}, {0.1F, 1.1F, 0.3F}), unlit({1, 1, 1}));
  const vo::PinholeCamera camera = wide_camera();
  std::vector<Vector2d> corners;
  for (const Vector3f& position : scene.meshes[0].positions) {
    corners.push_back(camera.project(position.cast<double>()));
  }
  const RenderedFrame frame = render(scene, kOneSample);
  constexpr double kEdge = 1e-4;  // px
  int hits = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const double depth_px = inside_by(corners, Vector2d(u, v));
      hits += depth_px > 0 ? 1 : 0;
      EXPECT_TRUE(vo::has_depth(frame.depth(v, u)) == (depth_px > 0) || std::abs(depth_px) < kEdge)
          << "pixel " << u << ", " << v;
    }
  }
  EXPECT_GT(hits, 300);
}

Mesh random_triangles(int count) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<float> place(-3, 3);
  std::uniform_real_distribution<float> extent(-0.8F, 0.8F);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vector3f centre(place(engine), place(engine), 4 + place(engine));
    for (int k = 0; k < 3; ++k) {
      mesh.positions.emplace_back(centre +
                                  Vector3f(extent(engine), extent(engine), extent(engine)));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Solves origin + depth ray = weighted vertices for every triangle.
double nearest_depth(const Mesh& mesh, const Vector3d& ray) {
  double nearest = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector3d a = mesh.positions[triangle[0]].cast<double>();
    Eigen::Matrix3d A;
    A << ray, a - mesh.positions[triangle[1]].cast<double>(),
        a - mesh.positions[triangle[2]].cast<double>();
    const Vector3d x = A.inverse() * a;
    const bool hit = x[0] > 0.01 && x[1] >= 0 && x[2] >= 0 && x[1] + x[2] <= 1;
    if (hit && (nearest == 0 || x[0] < nearest)) {
      nearest = x[0];
    }
  }
  return nearest;
}

TEST(RayTracer, DepthAgreesWithASearchThroughAllTriangles) {
  Scene scene;
  add(scene, random_triangles(300), unlit({1, 1, 1}));
  const RenderedFrame frame = render(scene, kOneSample, distorted_camera());
  const auto depth_along = [&](const Vector3d& ray) { return nearest_depth(scene.meshes[0], ray); };
  EXPECT_LT(max_depth_error(frame, distorted_camera(), depth_along), kRounding);
}

TEST(RayTracer, SurfacesNearerThanACentimetreAreNotSeen) {
  Scene scene;
  add(scene, square_at(0.009F, 1), unlit({1, 0, 0}));
  add(scene, square_at(1, 2), unlit({0, 1, 0}));
  const RenderedFrame frame = render(scene, kOneSample);
  EXPECT_EQ(frame.depth(24, 32), 1);
  EXPECT_EQ(frame.radiance(24, 32), cv::Vec3f(0, 1, 0));
}

TEST(RayTracer, ASceneWithoutTrianglesIsBlackAndHasNoDepth) {
  Scene scene;
  scene.meshes.emplace_back();
  scene.instances.push_back({.mesh = 0});
  scene.instances.push_back({.mesh = kNone});
  const RenderedFrame frame = render(scene, kOneSample);
  EXPECT_EQ(cv::countNonZero(frame.depth), 0);
  EXPECT_EQ(cv::norm(frame.radiance), 0);
}

TEST(RayTracer, AnEdgePixelShowsTheShareOfItsAreaThatIsCovered) {
  const vo::PinholeCamera camera = wide_camera();
  for (const double share : {0.25, 0.5, 0.75}) {
    const double edge_px = 40 - 0.5 + share;  // covers `share` of pixel 40
    const auto edge = static_cast<float>(camera.unproject({edge_px, 24}, 1).x());
    Scene scene;
    add(scene, quad({-2, -2, 1}, {2 + edge, 0, 0}, {0, 4, 0}), unlit({1, 1, 1}));
    const RenderedFrame frame = render(scene, {.samples = 16});
    EXPECT_EQ(frame.radiance(24, 39)[0], 1);
    EXPECT_EQ(frame.radiance(24, 40)[0], share);
    EXPECT_EQ(frame.radiance(24, 41)[0], 0);
  }
}

TEST(RayTracer, ShadowsFallWhereTheLightIsBlocked) {
  constexpr float kScreen = 2;     // m; the light is 2 m behind the camera
  constexpr float kShadow = 0.4F;  // m; a occluder's edge at 0.1, seen from 4 times as far
  Scene scene;
  add(scene, square_at(kScreen, 4), diffuse({1, 1, 1}));
  add(scene, quad({0.1F, -4, -1}, {4, 0, 0}, {0, 8, 0}), diffuse({1, 1, 1}));
  scene.lights.push_back(point_light({0, 0, -2}, {100, 100, 100}));
  const vo::PinholeCamera camera = wide_camera();
  const RenderedFrame frame = render(scene, {.samples = 1, .ambient = 0});
  for (int u = 0; u < camera.width; ++u) {
    const bool is_lit = camera.unproject(Vector2d(u, 10), kScreen).x() < kShadow;
    EXPECT_EQ(frame.radiance(10, u)[1] > 0, is_lit) << "column " << u;
  }
}

}  // namespace
}  // namespace synth
