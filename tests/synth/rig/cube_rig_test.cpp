#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "tests/support/box_room.h"
#include "vo/rigs/rig_file.h"

namespace synth {
namespace {

vo::Rig cube() {
  return vo::read_rig(EDVO_SOURCE_DIR "/assets/rigs/cube.toml");
}

/// What a camera sees along a ray, in the body's axes.
struct Seen {
  cv::Vec3f color;
  double distance;  ///< m, along the ray
  Eigen::Vector3d normal;
  int instance;
};

using Ray = std::array<int, 3>;  ///< direction in the body's axes, its greatest component kSteps
constexpr int kSteps = 32;

/// Returns what a face of the cube sees along the rays to its border, by a camera whose outermost
/// pixels' centres lie on the border.
std::vector<std::pair<Ray, Seen>> seen_at_border(const Renderer& renderer,
                                                 const vo::SE3& T_world_body,
                                                 const vo::RigCamera& face) {
  const vo::PinholeCamera camera{.width = 2 * kSteps + 1,
                                 .height = 2 * kSteps + 1,
                                 .fx = kSteps,
                                 .fy = kSteps,
                                 .cx = kSteps,
                                 .cy = kSteps};
  Capture capture = still(camera, T_world_body * face.T_body_camera);
  capture.channels = {.color = true, .depth = true, .normal = true, .ids = true};
  const RenderedFrame frame = renderer.render(capture);
  std::vector<std::pair<Ray, Seen>> border;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; u += v == 0 || v + 1 == camera.height ? 1 : 2 * kSteps) {
      const Eigen::Vector3d ray(u - kSteps, v - kSteps, kSteps);
      const Eigen::Vector3d in_body = face.T_body_camera.rotation() * ray;
      const cv::Vec3f& normal = frame.normal(v, u);
      border.push_back(
          {{static_cast<int>(std::lround(in_body.x())), static_cast<int>(std::lround(in_body.y())),
            static_cast<int>(std::lround(in_body.z()))},
           {frame.radiance(v, u), frame.depth(v, u) * ray.norm() / kSteps,
            face.T_body_camera.rotation() * Eigen::Vector3d(normal[0], normal[1], normal[2]),
            frame.instance(v, u)}});
    }
  }
  return border;
}

TEST(CubeRig, EachFaceIsAQuarterTurnWide) {
  const vo::Rig rig = cube();
  ASSERT_EQ(rig.cameras.size(), 6U);
  for (const vo::RigCamera& face : rig.cameras) {
    const vo::PinholeCamera& camera = *face.camera.model.pinhole();
    EXPECT_EQ(camera.unproject({-0.5, -0.5}, 1), Eigen::Vector3d(-1, -1, 1)) << face.name;
    EXPECT_EQ(camera.unproject({camera.width - 0.5, camera.height - 0.5}, 1),
              Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(face.T_body_camera.translation(), Eigen::Vector3d(0, 0, 0));
  }
}

TEST(CubeRig, ItsFacesLookWhereTheirNamesSay) {
  using Axis = Eigen::Vector3d;
  const std::map<std::string, std::pair<Axis, Axis>> forward_and_down{
      {"front", {{0, 0, 1}, {0, 1, 0}}}, {"right", {{1, 0, 0}, {0, 1, 0}}},
      {"back", {{0, 0, -1}, {0, 1, 0}}}, {"left", {{-1, 0, 0}, {0, 1, 0}}},
      {"up", {{0, -1, 0}, {0, 0, 1}}},   {"down", {{0, 1, 0}, {0, 0, -1}}}};
  for (const vo::RigCamera& face : cube().cameras) {
    const auto& [forward, down] = forward_and_down.at(face.name);
    EXPECT_LT((face.T_body_camera.rotation() * Axis::UnitZ() - forward).norm(), 1e-12) << face.name;
    EXPECT_LT((face.T_body_camera.rotation() * Axis::UnitY() - down).norm(), 1e-12) << face.name;
  }
}

TEST(CubeRig, NeighbouringFacesSeeTheSameAlongTheirCommonEdge) {
  const Scene scene = support::box_room();
  const auto renderer = make_renderer(scene, {.mode = RenderMode::unlit, .samples = 1});
  const vo::SE3 T_world_body(
      Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.3, 1, 0.2).normalized())),
      Eigen::Vector3d(0.4, -0.3, 0.2));
  std::map<Ray, std::vector<Seen>> rays;
  for (const vo::RigCamera& face : cube().cameras) {
    for (const auto& [ray, seen] : seen_at_border(*renderer, T_world_body, face)) {
      rays[ray].push_back(seen);
    }
  }
  EXPECT_EQ(rays.size(), 12U * (2 * kSteps - 1) + 8);  // edges and corners of a cube
  int different = 0;
  for (const auto& [ray, faces] : rays) {
    const auto at_end =
        std::count_if(ray.begin(), ray.end(), [](int x) { return std::abs(x) == kSteps; });
    ASSERT_EQ(faces.size(), static_cast<std::size_t>(at_end));
    for (const Seen& seen : faces) {
      const Seen& first = faces.front();
      const bool is_same = seen.instance == first.instance && seen.color == first.color &&
                           (seen.normal - first.normal).norm() < 1e-6 &&
                           std::abs(seen.distance - first.distance) < 1e-6 * first.distance;
      different += is_same ? 0 : 1;
    }
  }
  EXPECT_LE(different, 3);  // rays that meet an edge between two tiles
}

TEST(CubeRig, ItsFacesTogetherShowAnEquirectangularImageByItsClosedForm) {
  Scene scene;
  scene.environment.radiance.create(64, 128);
  for (int v = 0; v < 64; ++v) {
    for (int u = 0; u < 128; ++u) {
      scene.environment.radiance(v, u) = {static_cast<float>(u), static_cast<float>(v), 1};
    }
  }
  const auto renderer = make_renderer(scene, {.samples = 1});
  for (const vo::RigCamera& face : cube().cameras) {
    const vo::PinholeCamera& camera = *face.camera.model.pinhole();
    const RenderedFrame frame = renderer->render(still(camera, face.T_body_camera));
    for (const cv::Point& pixel : {cv::Point(0, 0), cv::Point(100, 37), cv::Point(255, 130)}) {
      const Eigen::Vector3d ray =
          (face.T_body_camera.rotation() * camera.unproject({pixel.x, pixel.y}, 1)).normalized();
      const double turns = std::atan2(ray.x(), -ray.z()) / (2 * std::numbers::pi);
      const double u = 128 * (turns + 0.5) - 0.5;
      const double v = 64 * std::acos(ray.y()) / std::numbers::pi - 0.5;
      EXPECT_NEAR(frame.radiance(pixel)[1], v, 1e-3) << face.name;
      if (u > 0 && u < 127) {
        EXPECT_NEAR(frame.radiance(pixel)[0], u, 1e-3) << face.name;
      }
    }
  }
}

TEST(PanoramaRig, ItsMiddleIsWhereTheFrontLooks) {
  const vo::Rig rig = vo::read_rig(EDVO_SOURCE_DIR "/assets/rigs/panorama.toml");
  ASSERT_EQ(rig.cameras.size(), 2U);
  const vo::CameraModel& panorama = rig.cameras[0].camera.model;
  const vo::CameraModel& front = rig.cameras[1].camera.model;
  ASSERT_EQ(panorama.projection(), vo::CameraProjection::equirectangular);
  EXPECT_LT((rig.cameras[0].T_body_camera.inverse() * rig.cameras[1].T_body_camera).log().norm(),
            1e-12);
  const Eigen::Vector2d forward = front.project({0, 0, 1});
  const Eigen::Vector2d middle((panorama.width() - 1) / 2.0, (panorama.height() - 1) / 2.0);
  EXPECT_LT((panorama.project(front.ray(forward)) - middle).norm(), 1e-9);
}

}  // namespace
}  // namespace synth
