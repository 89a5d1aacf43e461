#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/gltf/gltf.h"
#include "synth/rendering/renderer.h"
#include "synth/scene/texture.h"
#include "tests/support/quads.h"
#include "tests/support/textures.h"
#include "vo/core/error.h"

namespace synth {
namespace {

constexpr int kSize = 96;  // px
constexpr int kEdge = 2;   // px around a step of depth or a crease that are not compared

vo::PinholeCamera small_camera() {
  return vo::PinholeCamera::from_horizontal_fov(kSize, kSize, 70);
}

/// Both renderers' pictures of a scene.
struct Pair {
  RenderedFrame ray;
  RenderedFrame raster;
};

Pair render_both(const Scene& scene, RenderOptions options, const vo::SE3& T_world_camera) {
  Capture capture = still(small_camera(), T_world_camera);
  capture.channels.normal = true;
  capture.channels.ids = true;
  Pair pair;
  options.kind = RendererKind::ray_tracer;
  pair.ray = make_renderer(scene, options)->render(capture);
  options.kind = RendererKind::rasterizer;
  pair.raster = make_renderer(scene, options)->render(capture);
  return pair;
}

/// Returns whether depth and normal hardly change around a pixel.
bool is_inside_a_surface(const RenderedFrame& frame, int v, int u) {
  if (v < kEdge || u < kEdge || v >= kSize - kEdge || u >= kSize - kEdge) {
    return false;
  }
  const float depth = frame.depth(v, u);
  for (int dv = -kEdge; dv <= kEdge; ++dv) {
    for (int du = -kEdge; du <= kEdge; ++du) {
      const cv::Vec3f turn = frame.normal(v + dv, u + du) - frame.normal(v, u);
      const float step = frame.depth(v + dv, u + du) - depth;
      if (cv::norm(turn) > 0.02 || std::abs(step) > 0.1F * depth) {
        return false;
      }
    }
  }
  return true;
}

/// Over all pixels away from edges.
struct Disagreement {
  int compared = 0;
  int hits = 0;               ///< seen by one alone
  std::vector<double> depth;  ///< m
  double normal = 0;          ///< greatest
  int instances = 0;          ///< of other ids
  int materials = 0;          ///< the same
  std::vector<double> color;
};

Disagreement compare(const Pair& pair) {
  Disagreement worst;
  for (int v = 0; v < kSize; ++v) {
    for (int u = 0; u < kSize; ++u) {
      if (!is_inside_a_surface(pair.ray, v, u)) {
        continue;
      }
      ++worst.compared;
      worst.hits += (pair.ray.depth(v, u) > 0) != (pair.raster.depth(v, u) > 0) ? 1 : 0;
      worst.depth.push_back(std::abs(pair.ray.depth(v, u) - pair.raster.depth(v, u)));
      worst.normal =
          std::max(worst.normal, cv::norm(pair.ray.normal(v, u) - pair.raster.normal(v, u)));
      worst.instances += pair.ray.instance(v, u) != pair.raster.instance(v, u) ? 1 : 0;
      worst.materials += pair.ray.material(v, u) != pair.raster.material(v, u) ? 1 : 0;
      worst.color.push_back(cv::norm(pair.ray.radiance(v, u) - pair.raster.radiance(v, u)));
    }
  }
  std::sort(worst.color.begin(), worst.color.end());
  std::sort(worst.depth.begin(), worst.depth.end());
  return worst;
}

const std::filesystem::path kRoom =
    std::filesystem::path(EDVO_SOURCE_DIR) / "assets/room/room.gltf";

vo::SE3 in_the_room() {
  return {Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY()) *
              Eigen::AngleAxisd(3.14159265358979, Eigen::Vector3d::UnitX()),
          {0.3, 1.4, 0.2}};
}

TEST(RenderersAgree, OnDepthNormalsAndUnlitColorOfTheRoom) {
  const Pair pair =
      render_both(load_gltf(kRoom), {.mode = RenderMode::unlit, .samples = 4}, in_the_room());
  const Disagreement worst = compare(pair);
  EXPECT_GT(worst.compared, kSize * kSize / 3);
  EXPECT_EQ(worst.hits, 0);
  EXPECT_LT(worst.depth[worst.depth.size() * 99 / 100], 1e-5);
  EXPECT_LT(worst.depth.back(), 5e-3);  // of things that lie on each other, one or the other
  EXPECT_LT(worst.normal, 2e-3);
  EXPECT_LT(worst.color[worst.color.size() / 2], 0.01);
  EXPECT_LT(worst.color[worst.color.size() * 95 / 100], 0.06);
}

/// The rasteriser's vertices lie on a grid of 1/256 px, so that outlines are up to half of that
/// off.
TEST(RenderersAgree, OnDepthOfEveryPixelUpToTheGridOfVertices) {
  constexpr double kRelative = 1e-4;
  const Scene scene = load_gltf(kRoom);
  const Pair pair = render_both(scene, {.mode = RenderMode::depth}, in_the_room());
  const auto renderer = make_renderer(scene, {.mode = RenderMode::depth});
  std::vector<RenderedFrame> beside;
  for (const double dx : {-1.0 / 512, 0.0, 1.0 / 512}) {
    for (const double dy : {-1.0 / 512, 0.0, 1.0 / 512}) {
      vo::PinholeCamera camera = small_camera();
      camera.cx += dx;
      camera.cy += dy;
      beside.push_back(renderer->render(still(camera, in_the_room())));
    }
  }
  int other = 0;
  int unexplained = 0;
  for (int v = 0; v < kSize; ++v) {
    for (int u = 0; u < kSize; ++u) {
      const float depth = pair.raster.depth(v, u);
      const auto sees_it = [&](const RenderedFrame& frame) {
        return std::abs(frame.depth(v, u) - depth) <= kRelative * depth;
      };
      other += sees_it(pair.ray) ? 0 : 1;
      unexplained += std::any_of(beside.begin(), beside.end(), sees_it) ? 0 : 1;
    }
  }
  EXPECT_LE(other, kSize * kSize / 2000);
  EXPECT_LE(unexplained, 2);
}

/// A tilted square with every kind of map-free surface, and a lamp of each kind.
Scene lit_square() {
  Scene scene;
  Material material = diffuse({0.8F, 0.5F, 0.3F});
  material.specular = 1;
  material.roughness = 0.4F;
  material.metallic = 0.3F;
  material.emission = {0.01F, 0, 0.02F};
  Mesh mesh = quad({-6, -6, 2}, {12, 0, 3}, {0, 12, -1});
  mesh.normals.assign(4, Eigen::Vector3f(0.2F, 0.1F, -1).normalized());
  mesh.colors = {{1, 1, 1, 1}, {0, 1, 1, 1}, {1, 0, 1, 1}, {1, 1, 0, 1}};
  add(scene, mesh, material);
  scene.lights.push_back(point_light({0.5, -0.4, 0.3}, {6, 6, 6}));
  Light spot = point_light({-0.6, 0.2, 0}, {9, 3, 3});
  spot.kind = LightKind::spot;
  spot.direction = {0, 0, 1};
  spot.inner_cone = 0.2;
  spot.outer_cone = 0.5;
  spot.range = 9;
  scene.lights.push_back(spot);
  Light sun;
  sun.kind = LightKind::directional;
  sun.direction = Eigen::Vector3d(-0.3, 0.2, 1).normalized();
  scene.lights.push_back(sun);
  return scene;
}

TEST(RenderersAgree, OnDirectLightWhereNothingCastsAShadow) {
  const Pair pair = render_both(lit_square(), {.samples = 1}, {});
  const Disagreement worst = compare(pair);
  EXPECT_GT(worst.compared, kSize * kSize * 3 / 4);
  EXPECT_LT(worst.color.back(), 2e-3);
  EXPECT_LT(worst.depth.back(), 1e-5);
}

TEST(RenderersAgree, OnColouredDielectricsWithMaps) {
  Scene scene = lit_square();
  Material& material = scene.materials[0];
  material.metallic = 0.1F;
  material.specular_color = {9, 30, 0.5F};
  material.specular_color_texture = plain_texture(scene, {204, 102, 51, 255});
  material.specular_texture = plain_texture(scene, {0, 0, 0, 153});
  const Pair pair = render_both(scene, {.samples = 1}, {});
  EXPECT_LT(compare(pair).color.back(), 2e-3);
  const RenderedFrame plain =
      make_renderer(lit_square(), {.samples = 1})->render(small_camera(), {});
  EXPECT_GT(cv::norm(plain.radiance, pair.ray.radiance, cv::NORM_INF), 0.05);
}

/// A floor of 64 x 64 dark and bright squares, seen at 3 to 20 degrees.
Scene checkered_floor() {
  cv::Mat_<cv::Vec4b> texels(256, 256);
  for (int v = 0; v < texels.rows; ++v) {
    for (int u = 0; u < texels.cols; ++u) {
      texels(v, u) = (u / 4 + v / 4) % 2 == 0 ? cv::Vec4b::all(255) : cv::Vec4b(0, 0, 0, 255);
    }
  }
  Scene scene;
  Material material = unlit({1, 1, 1});
  material.base_color_texture.texture = 0;
  scene.textures.push_back({.image = 0});
  scene.images.push_back(build_mip_levels(texels, TexelEncoding::linear));
  add(scene, quad({-8, 1, 20}, {16, 0, 0}, {0, 0, -20}), material);
  return scene;
}

/// Returns the root-mean-square error of the floor's picture with this anisotropy.
double error_on_floor(RendererKind kind, int anisotropy, const cv::Mat_<cv::Vec3f>& truth) {
  RenderOptions options{.kind = kind, .mode = RenderMode::unlit, .samples = 1};
  options.anisotropy = anisotropy;
  const RenderedFrame frame = make_renderer(checkered_floor(), options)->render(small_camera(), {});
  return cv::norm(frame.radiance, truth) / kSize;
}

TEST(RenderersAgree, ThatAnisotropyShowsASlantedFloorAsManySamplesDo) {
  const cv::Mat_<cv::Vec3f> truth =
      make_renderer(checkered_floor(), {.mode = RenderMode::unlit, .samples = 1024})
          ->render(small_camera(), {})
          .radiance;
  for (const RendererKind kind : {RendererKind::ray_tracer, RendererKind::rasterizer}) {
    const double isotropic = error_on_floor(kind, 1, truth);
    EXPECT_LT(error_on_floor(kind, 16, truth), 0.6 * isotropic) << isotropic;
  }
}

/// Where light, viewer and normal are one direction, cosines rounded beyond 1 must do no harm.
TEST(RenderersAgree, OnALampAtTheCamera) {
  Scene scene;
  Material glossy = diffuse({0.8F, 0.5F, 0.3F});
  glossy.specular = 1;
  glossy.roughness = 0.3F;
  add(scene, square_at(2, 2), glossy);
  scene.lights.push_back(point_light({0, 0, 0}, {5, 5, 5}));
  const Disagreement worst = compare(render_both(scene, {.samples = 1}, {}));
  EXPECT_GT(worst.compared, kSize * kSize / 2);
  EXPECT_LT(worst.color.back(), 1e-3);
}

/// The ids that are in an image, but for 0.
std::set<int> ids_in(const IdImage& image) {
  std::set<int> ids(image.begin(), image.end());
  ids.erase(0);
  return ids;
}

TEST(RenderersAgree, OnIdsOfInstancesAndMaterials) {
  const Pair pair = render_both(load_gltf(kRoom), {.mode = RenderMode::depth}, in_the_room());
  const Disagreement worst = compare(pair);
  EXPECT_GT(worst.compared, kSize * kSize / 3);
  EXPECT_LE(worst.instances, worst.compared / 1000);  // of things that lie on each other
  EXPECT_LE(worst.materials, worst.compared / 1000);
  EXPECT_GE(ids_in(pair.ray.instance).size(), 5U);
  EXPECT_GE(ids_in(pair.ray.material).size(), 3U);
}

TEST(RenderersAgree, OnIdsBehindHolesAndBesideTheScene) {
  Scene scene;
  Material hole = unlit({1, 0, 0});
  hole.alpha_mode = AlphaMode::mask;
  hole.base_color.w() = 0.25F;
  add(scene, square_at(1, 0.5F), hole);
  add(scene, square_at(2, 1), unlit({0, 1, 0}));
  scene.meshes.back().material = kNone;
  const Pair pair = render_both(scene, {.samples = 1}, {});
  const Disagreement worst = compare(pair);
  EXPECT_EQ(worst.instances + worst.materials, 0);
  EXPECT_EQ(ids_in(pair.raster.instance), std::set<int>{2});
  EXPECT_EQ(ids_in(pair.raster.material), std::set<int>{3}) << "none of the two";
  EXPECT_EQ(pair.raster.instance(0, 0), 0);
}

TEST(RenderersAgree, OnMaskedAndBlendedSurfaces) {
  for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
    for (const float alpha : {0.25F, 0.75F}) {
      const Disagreement worst =
          compare(render_both(red_before_green(mode, alpha), {.samples = 16}, {}));
      EXPECT_GT(worst.compared, 0);
      EXPECT_LT(worst.depth.back(), 1e-6);
      EXPECT_LT(worst.color.back(), 0.05);
    }
  }
}

TEST(Rasterizer, GivesTheSameBitsAgain) {
  const Scene scene = lit_square();
  const auto renderer = make_renderer(scene, {.kind = RendererKind::rasterizer});
  const Capture capture = still(small_camera(), {});
  const RenderedFrame first = renderer->render(capture);
  EXPECT_EQ(cv::norm(first.radiance, renderer->render(capture).radiance, cv::NORM_INF), 0);
}

TEST(Rasterizer, RefusesWhatItCannotDraw) {
  const Scene scene = lit_square();
  const RenderOptions raster{.kind = RendererKind::rasterizer};
  vo::PinholeCamera distorted = small_camera();
  distorted.distortion.k1 = 0.1;
  EXPECT_THROW(make_renderer(scene, raster)->render(still(distorted, {})), vo::Error);
  const vo::EquirectangularCamera panorama{.width = 32, .height = 16};
  EXPECT_THROW(make_renderer(scene, raster)->render(still(panorama, {})), vo::Error);
  Capture capture = still(small_camera(), {});
  capture.shutter.readout_time = 0.02;
  EXPECT_THROW(make_renderer(scene, raster)->render(capture), vo::Error);
  EXPECT_THROW(make_renderer(scene, {.kind = RendererKind::rasterizer, .mode = RenderMode::path}),
               vo::Error);
}

TEST(Rasterizer, SaysBeforehandWhatItCannotDraw) {
  const RenderOptions traced;
  const RenderOptions raster{.kind = RendererKind::rasterizer};
  Scene scene = lit_square();
  scene.lights.resize(64, scene.lights.front());
  EXPECT_NO_THROW(require_drawable(scene, raster));
  EXPECT_NO_THROW(make_renderer(scene, raster));
  scene.lights.push_back(scene.lights.front());
  EXPECT_THROW(require_drawable(scene, raster), vo::Error);
  EXPECT_THROW(make_renderer(scene, raster), vo::Error);
  EXPECT_NO_THROW(require_drawable(scene, traced));
  const Shutter rolling{.readout_time = 0.02};
  EXPECT_NO_THROW(require_drawable(small_camera(), {}, raster));
  EXPECT_THROW(require_drawable(small_camera(), rolling, raster), vo::Error);
  EXPECT_NO_THROW(require_drawable(small_camera(), rolling, traced));
}

}  // namespace
}  // namespace synth
