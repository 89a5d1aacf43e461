#include "synth/rendering/multipath.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "synth/camera/make_renderer.h"
#include "synth/ray_tracing/ray_tracer.h"
#include "synth/scene/scene_motion.h"
#include "tests/support/quads.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using Complex = std::complex<double>;

constexpr double kFrequency = 200e6;  // Hz
const cv::Point kAhead(32, 24);

MultipathOptions followed(int samples, int bounces, LampField lamp = LampField::all) {
  return {.frequency = kFrequency, .samples = samples, .bounces = bounces, .lamp = lamp};
}

Capture multipath_capture(const vo::CameraModel& camera, const MultipathOptions& options) {
  Capture capture = still(camera, {});
  capture.channels = {.color = false, .normal = true, .sight = true, .multipath = true};
  capture.multipath = options;
  return capture;
}

/// Returns what a camera that stands still sees of a scene.
RenderedFrame frame_of(const Scene& scene, const MultipathOptions& options,
                       const vo::CameraModel& camera = wide_camera()) {
  return make_ray_tracer(scene, {.mode = RenderMode::depth})
      ->render(multipath_capture(camera, options));
}

double wave_number(double frequency) {
  return 2 * std::numbers::pi * frequency / 299792458;
}

/// Returns the light that reaches a pixel from elsewhere over that which returns straight.
Complex ratio_at(const RenderedFrame& frame, const cv::Point& pixel) {
  const cv::Vec2d other = frame.sight.multipath(pixel);
  return Complex(other[0], other[1]) / static_cast<double>(frame.sight.beyond_returned(pixel));
}

/// Returns how much farther along its ray a pixel measures a surface than it is, m.
double detour_at(const RenderedFrame& frame, const cv::Point& pixel,
                 double frequency = kFrequency) {
  return std::arg(1.0 + ratio_at(frame, pixel)) / (2 * wave_number(frequency));
}

/// A sphere about the origin, of nearly equal triangles: those of an octahedron, divided.
Mesh sphere(float radius, int divisions) {
  Mesh mesh;
  for (int octant = 0; octant < 8; ++octant) {
    const Vector3f side((octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1,
                        (octant & 4) != 0 ? -1 : 1);
    const auto corner = [&](int i, int j) {
      const Vector3f place(static_cast<float>(i), static_cast<float>(j),
                           static_cast<float>(divisions - i - j));
      mesh.positions.emplace_back(radius * place.normalized().cwiseProduct(side));
      return static_cast<int>(mesh.positions.size()) - 1;
    };
    for (int i = 0; i < divisions; ++i) {
      for (int j = 0; i + j < divisions; ++j) {
        mesh.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i, j + 1)});
        if (i + j + 1 < divisions) {
          mesh.triangles.push_back({corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
        }
      }
    }
  }
  return mesh;
}

/// Returns the mean of exp(i k l) over the chords l from a point of a sphere's inside, by the
/// cosine at the point, which spreads their lengths with the density l / (2 R^2).
Complex mean_phasor_of_chords(double radius) {
  const Complex ik(0, wave_number(kFrequency));
  const auto integral = [&](double l) { return std::exp(ik * l) * (l / ik - 1.0 / (ik * ik)); };
  return (integral(2 * radius) - integral(0)) / (2 * radius * radius);
}

/// Expects what a camera in the middle of a sphere measures.
void expect_series_of_chords(const vo::CameraModel& camera) {
  constexpr double kRadius = 1.5;
  constexpr float kAlbedo = 0.6F;
  Scene scene;
  add(scene, sphere(kRadius, 24), diffuse(Vector3f::Constant(kAlbedo)));
  Complex sum = 1;
  Complex order = 1;
  for (int bounces = 1; bounces <= 3; ++bounces) {
    order *= static_cast<double>(kAlbedo) * mean_phasor_of_chords(kRadius);
    sum += order;
    const RenderedFrame frame = frame_of(scene, followed(256, bounces), camera);
    double mean = 0;
    for (int v = 0; v < camera.height(); ++v) {
      for (int u = 0; u < camera.width(); ++u) {
        mean += detour_at(frame, {u, v}) / (camera.width() * camera.height());
      }
    }
    EXPECT_NEAR(mean, std::arg(sum) / (2 * wave_number(kFrequency)), 5e-4) << bounces << " bounces";
  }
}

TEST(Multipath, InASphereIsASeriesOfChords) {
  expect_series_of_chords(vo::PinholeCamera::from_horizontal_fov(8, 6, 70));
  expect_series_of_chords(vo::EquirectangularCamera{.width = 10, .height = 5});
}

TEST(Multipath, OfALoneWallIsNone) {
  Scene scene;
  add(scene, quad({-3, -3, 2}, {6, 0, 1}, {0, 6, 0.5F}), diffuse({1, 1, 1}));
  const RenderedFrame frame = frame_of(scene, followed(4, 2));
  EXPECT_GT(frame.depth(kAhead), 0);
  EXPECT_EQ(cv::norm(frame.sight.multipath, cv::NORM_INF), 0);
}

constexpr float kWall = 2;      // m, depth of a wall across the optical axis
constexpr float kFloor = 0.7F;  // m, of a floor below the camera that ends at the wall

/// A wall across the optical axis and a floor, or a table, below the camera, all m.
struct WallAndFloor {
  float wall = kWall;      ///< depth of the wall
  float below = kFloor;    ///< of the floor, where the wall ends too
  float near = kWall - 4;  ///< depth at which the floor begins
  float far = kWall;       ///< depth at which it ends
  float half_width = 4;    ///< of the floor
};

Scene scene_of(const WallAndFloor& place, float albedo) {
  Scene scene;
  const Material material = diffuse(Vector3f::Constant(albedo));
  add(scene, quad({-4, -3, place.wall}, {8, 0, 0}, {0, 3 + place.below, 0}), material);
  add(scene,
      quad({-place.half_width, place.below, place.far}, {2 * place.half_width, 0, 0},
           {0, 0, place.near - place.far}),
      material);
  return scene;
}

/// The concave corner of a wall and a floor, which is this far below the camera, m.
Scene corner_of(float albedo, float floor = kFloor) {
  return scene_of({.below = floor}, albedo);
}

/// One pixel that looks at a place of the plane z = 1.
vo::PinholeCamera camera_towards(double x, double y) {
  return {.width = 1, .height = 1, .fx = 1, .fy = 1, .cx = -x, .cy = -y};
}

TEST(Multipath, InACornerGrowsTowardsItAndWithTheAlbedo) {
  constexpr double kSlow = 20e6;  // Hz, whose waves are far longer than all ways
  MultipathOptions options = followed(1024, 2);
  options.frequency = kSlow;
  double before = 0;
  for (const double below : {0.0, 0.3, 0.6, 0.9}) {
    const vo::PinholeCamera camera = camera_towards(0, below);
    const RenderedFrame grey = frame_of(corner_of(0.4F, kWall), options, camera);
    const RenderedFrame white = frame_of(corner_of(0.8F, kWall), options, camera);
    EXPECT_GT(detour_at(grey, {0, 0}, kSlow), 0.02) << below;
    EXPECT_GT(detour_at(white, {0, 0}, kSlow), 1.8 * detour_at(grey, {0, 0}, kSlow)) << below;
    EXPECT_GT(std::abs(ratio_at(grey, {0, 0})), before + 0.01) << below;
    before = std::abs(ratio_at(grey, {0, 0}));
  }
}

TEST(Multipath, OfBlackWallsIsNone) {
  const RenderedFrame black = frame_of(corner_of(0), followed(4, 2));
  EXPECT_GT(black.depth(kAhead), 0);
  EXPECT_EQ(cv::norm(black.sight.multipath, cv::NORM_INF), 0);
}

/// Returns the detour, m, at a point of the wall x m aside of and y m below the optical axis, by
/// light that the floor reflects, summed over the floor's area: small squares that are lit by the
/// lamp and light the point.
double detour_by_floor(const WallAndFloor& place, double x, double y, double albedo) {
  constexpr double kStep = 0.01;  // m
  const Vector3d seen(x, y, place.wall);
  const double cosine = place.wall / seen.norm();
  const double direct = albedo / std::numbers::pi * cosine / seen.squaredNorm();
  Complex sum = direct;
  for (double z = place.far - kStep / 2; z > place.near; z -= kStep) {
    for (double aside = -place.half_width + kStep / 2; aside < place.half_width; aside += kStep) {
      const Vector3d lit(aside, place.below, z);
      const Vector3d chord = lit - seen;
      const double l2 = chord.squaredNorm();
      const double irradiance = place.below / lit.norm() / lit.squaredNorm();
      const double form = (place.wall - z) * (place.below - y) / (l2 * l2);
      const double radiance =
          albedo / std::numbers::pi * albedo / std::numbers::pi * irradiance * form * kStep * kStep;
      sum += std::polar(radiance,
                        wave_number(kFrequency) * (lit.norm() + std::sqrt(l2) - seen.norm()));
    }
  }
  return std::arg(sum) / (2 * wave_number(kFrequency));
}

TEST(Multipath, InACornerIsTheIntegralOverTheOtherWall) {
  for (const auto& [x, y] : {std::pair(0.0, 0.2), {0.0, 0.0}, {-0.6, 0.1}}) {
    const RenderedFrame frame =
        frame_of(corner_of(0.8F), followed(1 << 14, 1), camera_towards(x, y));
    const double expected = detour_by_floor({}, kWall * x, kWall * y, 0.8);
    EXPECT_GT(expected, 0.005);
    EXPECT_NEAR(detour_at(frame, {0, 0}), expected, 0.005 * expected + 5e-5) << x << ", " << y;
  }
}

/// The lamp lights the table up to 40 times as brightly as the wall.
TEST(Multipath, ByATableBesideTheLampIsTheIntegralOverTheTable) {
  const WallAndFloor table{.wall = 3, .below = 0.3F, .near = 0.2F, .far = 1, .half_width = 0.8F};
  const RenderedFrame frame =
      frame_of(scene_of(table, 0.8F), followed(1 << 15, 1), camera_towards(0, -0.4));
  const double expected = detour_by_floor(table, 0, -0.4 * table.wall, 0.8);
  EXPECT_NEAR(detour_at(frame, {0, 0}), expected, 0.02 * std::abs(expected));
}

TEST(Multipath, DoesNotTellColoursOfReflectionsApart) {
  Material glossy = diffuse(Vector3f::Constant(0.4F));
  glossy.specular = 1;
  glossy.roughness = 0.4F;
  const auto frame_in = [&](const Vector3f& specular_color) {
    Material material = glossy;
    material.specular_color = specular_color;
    Scene scene = corner_of(0);
    scene.materials = {material, material};
    return frame_of(scene, followed(4, 2));
  };
  const RenderedFrame red = frame_in({1, 0.2F, 0.05F});
  for (const Vector3f& permuted : {Vector3f(0.2F, 1, 0.05F), Vector3f(0.05F, 0.2F, 1)}) {
    const RenderedFrame other = frame_in(permuted);
    EXPECT_LT(cv::norm(red.sight.multipath, other.sight.multipath, cv::NORM_INF), 1e-6);
    EXPECT_LT(cv::norm(red.sight.beyond_returned, other.sight.beyond_returned, cv::NORM_INF), 1e-6);
  }
}

/// The polynomial of this lens images what is 61 degrees off its axis again near the image's
/// middle.
TEST(Multipath, DoesNotComeFromWhereTheLensFoldsBack) {
  vo::PinholeCamera camera{.width = 32, .height = 24, .fx = 60, .fy = 60, .cx = 15.5, .cy = 11.5};
  camera.distortion.k1 = -0.3;
  Scene scene;
  add(scene, square_at(kWall, 0.6F), diffuse({1, 1, 1}));
  add(scene, quad({1.8F, -1, 0.8F}, {0, 0, 0.4F}, {0, 2, 0}), diffuse({1, 1, 1}));
  const auto amount = [&](LampField lamp) {
    return cv::norm(frame_of(scene, followed(64, 1, lamp), camera).sight.multipath, cv::NORM_INF);
  };
  EXPECT_GT(amount(LampField::all), 0.001);
  EXPECT_EQ(amount(LampField::view), 0);
}

TEST(Multipath, ComesFromTheFieldOfTheLampAlone) {
  Scene scene = corner_of(0.8F);
  add(scene, quad({-4, -3, -1}, {8, 0, 0}, {0, 3.7F, 0}), diffuse({1, 1, 1}));  // behind
  const RenderedFrame view = frame_of(scene, followed(64, 1, LampField::view));
  const RenderedFrame without = frame_of(corner_of(0.8F), followed(64, 1, LampField::view));
  EXPECT_EQ(cv::norm(view.sight.multipath, without.sight.multipath, cv::NORM_INF), 0);
  const RenderedFrame all = frame_of(scene, followed(64, 1, LampField::all));
  EXPECT_GT(std::abs(ratio_at(all, kAhead) - ratio_at(view, kAhead)), 0.1);
}

/// What stands between lamp and floor shades the light that the floor sends to the wall.
TEST(Multipath, IsLessWhereTheOtherSurfaceIsInShadow) {
  Scene shaded = corner_of(0.8F);
  add(shaded, quad({-4, 0.05F, 0.2F}, {8, 0, 0}, {0, 0.5F, 0}), diffuse({0, 0, 0}));
  const cv::Point on_wall(32, 20);
  const RenderedFrame frame = frame_of(shaded, followed(64, 1));
  EXPECT_NEAR(frame.depth(on_wall), kWall, 1e-6);
  EXPECT_LT(std::abs(ratio_at(frame, on_wall)),
            0.5 * std::abs(ratio_at(frame_of(corner_of(0.8F), followed(64, 1)), on_wall)));
}

TEST(Multipath, OfARollingShutterIsThatOfEachRowsOwnPose) {
  const Scene scene = corner_of(0.8F);
  const auto motion = [](double time) {
    return vo::SE3(Eigen::Quaterniond::Identity(), Vector3d(0, -2 * time, 3 * time));
  };
  Capture capture = multipath_capture(wide_camera(), followed(4, 2, LampField::view));
  const auto renderer = make_ray_tracer(scene, {.mode = RenderMode::depth});
  capture.shutter.readout_time = 0.1;
  capture.motion = motion;
  const RenderedFrame rolling = renderer->render(capture);
  for (const int v : {0, 30, 44}) {
    const double time = capture.shutter.row_time(v, capture.camera.height());
    Capture at_rest = capture;
    at_rest.shutter = {};
    at_rest.motion = [&](double) { return motion(time); };
    const RenderedFrame still_frame = renderer->render(at_rest);
    EXPECT_LT(
        cv::norm(rolling.sight.multipath.row(v), still_frame.sight.multipath.row(v), cv::NORM_INF),
        1e-6)
        << v;
  }
}

/// The corner whose floor sinks from kFloor to 0.2 m more in 1 s.
Scene corner_with_sinking_floor() {
  Scene scene = corner_of(0.8F, kFloor + 0.2F);
  scene.meshes[1] = corner_of(0.8F).meshes[1];
  scene.motion.nodes.resize(2);
  scene.motion.instance_nodes = {0, 1};
  const AnimationCurve curve{.width = 3, .times = {0, 1}, .values = {0, 0, 0, 0, 0.2F, 0}};
  scene.motion.animations = {
      {.duration = 1,
       .channels = {{.node = 1, .property = AnimatedProperty::translation, .curve = curve}}}};
  return scene;
}

TEST(Multipath, OfMovingThingsIsThatOfTheirPlaces) {
  const Scene scene = corner_with_sinking_floor();
  Capture capture = multipath_capture(wide_camera(), followed(8, 2));
  capture.scene_time = 0.75;
  const SceneDuring during = scene_during(scene, 0.5, 0, 1);
  const RenderedFrame moving_floor =
      make_ray_tracer(during, {.mode = RenderMode::depth})->render(capture);
  Scene at_rest = corner_of(0.8F, kFloor + 0.2F);
  at_rest.meshes[1] = corner_of(0.8F, kFloor + 0.15F).meshes[1];
  const RenderedFrame floor_at_rest = frame_of(at_rest, followed(8, 2));
  EXPECT_LT(cv::norm(moving_floor.depth, floor_at_rest.depth, cv::NORM_INF), 1e-5);
  EXPECT_LT(cv::norm(moving_floor.sight.multipath.rowRange(0, 30),
                     floor_at_rest.sight.multipath.rowRange(0, 30), cv::NORM_INF),
            1e-4);
}

/// Of the straight light a pane passes (1 - F) / (1 + F) twice, of the other light once.
TEST(Multipath, BehindGlassIsThatOfWhatIsThere) {
  Material pane = diffuse({1, 1, 1});
  pane.specular = 1;
  pane.roughness = 0;
  pane.layers.transmission = 1;
  Scene behind = corner_of(0.8F);
  add(behind, square_at(0.05F, 0.005F), pane);
  const RenderedFrame direct = frame_of(corner_of(0.8F), followed(64, 1));
  const RenderedFrame through = frame_of(behind, followed(64, 1));
  EXPECT_LT(std::abs(ratio_at(through, kAhead) / ratio_at(direct, kAhead) - 1.04 / 0.96), 0.001);
}

/// A wall behind the camera lights the wall before it, straight and by way of the floor.
Scene facing_walls(const Material& floor) {
  Scene scene;
  add(scene, quad({-4, -3, kWall}, {8, 0, 0}, {0, 3 + kFloor, 0}), diffuse({1, 1, 1}));
  add(scene, quad({-4, kFloor, kWall}, {8, 0, 0}, {0, 0, -4}), floor);
  add(scene, quad({-4, -3, kWall - 4}, {8, 0, 0}, {0, 3 + kFloor, 0}), diffuse({1, 1, 1}));
  return scene;
}

TEST(Multipath, ComesByMirrorsWhichTheLampItselfDoesNotLight) {
  Material mirror = diffuse({1, 1, 1});
  mirror.metallic = 1;
  mirror.roughness = 0;
  const Scene mirrored = facing_walls(mirror);
  const Scene black = facing_walls(diffuse({0, 0, 0}));
  const auto ahead = [](const Scene& scene, int bounces) {
    return ratio_at(frame_of(scene, followed(1024, bounces), camera_towards(0, 0)), {0, 0});
  };
  EXPECT_EQ(ahead(mirrored, 1), ahead(black, 1));
  EXPECT_GT(std::abs(ahead(mirrored, 2) - ahead(black, 2)), 0.01);
}

TEST(MultipathOptions, RefuseWhatIsNoFrequencyAndNoCount) {
  EXPECT_NO_THROW(MultipathOptions{}.validate());
  EXPECT_NO_THROW(MultipathOptions{.frequency = kFrequency}.validate());
  for (const double frequency : {-1.0, 200.0, 1e11, std::nan("")}) {
    EXPECT_THROW(MultipathOptions{.frequency = frequency}.validate(), vo::Error) << frequency;
  }
  EXPECT_THROW(MultipathOptions{.samples = 0}.validate(), vo::Error);
  EXPECT_THROW(MultipathOptions{.bounces = 0}.validate(), vo::Error);
  EXPECT_THROW(MultipathOptions{.radius = -1}.validate(), vo::Error);
  EXPECT_THROW(MultipathOptions{.max_error = -0.1}.validate(), vo::Error);
}

}  // namespace
}  // namespace synth
