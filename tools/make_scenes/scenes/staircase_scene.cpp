#include <string>

#include "tools/make_scenes/furniture/architecture.h"
#include "tools/make_scenes/furniture/books.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/lamps.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

constexpr double kHalfX = 1.4;    // m
constexpr double kNorth = -3.0;   // m, z of the wall behind the landing
constexpr double kSouth = 2.6;    // m
constexpr double kCeiling = 5.8;  // m
constexpr double kGap = 0.001;    // m
constexpr Flight kFlight = {.steps = 9, .rise = 0.17, .going = 0.28, .width = 1.25};
constexpr double kFoot = 1.0;                                    // m, z of the first riser
constexpr double kTurn = kFoot - kFlight.going * kFlight.steps;  // m, z where the landing begins
constexpr double kLanding = kFlight.rise * (kFlight.steps + 1);  // m above the floor
constexpr double kUpper = 2 * kLanding;                          // m, the upper floor
constexpr double kSlab = 0.2;                                    // m, thickness of floors
constexpr double kFlightX = 0.7;                                 // m, to both sides

Mesh stairwell() {
  Mesh mesh = {"stairwell", {}};
  const Vector3d x(2 * kHalfX, 0, 0);
  const Vector3d y(0, kCeiling, 0);
  const Vector3d z(0, 0, kSouth - kNorth);
  const Vector3d corner(-kHalfX, 0, kNorth);
  add(mesh, Finish::tiles, rectangle(corner, x, z));
  add(mesh, Finish::ceiling, rectangle(corner + y + z, x, -z));
  add(mesh, Finish::brick, rectangle(corner + y, x, -y));
  add(mesh, Finish::plain_wall, rectangle(corner + x + y, z, -y));
  add(mesh, Finish::plain_wall, rectangle(corner + x + y + z, -x, -y));
  add(mesh, Finish::wallpaper, rectangle(corner + y + z, -z, -y));
  return mesh;
}

/// Returns a floor of oak on a white slab, its upper face at y = 0, from `from` to `to` along z.
Mesh landing(double from, double to) {
  Mesh mesh = {"landing", {}};
  const double length = to - from;
  const double middle = (from + to) / 2;
  add(mesh, Finish::oak, plank({2 * kHalfX, 0.03, length}, 0.003), at(0, -0.015, middle));
  add(mesh, Finish::white_paint, box({2 * kHalfX, kSlab - 0.03, length - 0.02}),
      at(0, -0.03 - (kSlab - 0.03) / 2, middle));
  return mesh;
}

void add_stairs(ModelBuilder& scene, int root) {
  const int flight = scene.add_mesh(flight_of_stairs(kFlight));
  const int rail = scene.add_mesh(banister(kFlight));
  const double inner = kFlight.width / 2 - 0.05;
  const int lower = scene.place(root, "lower_flight", flight, at(kFlightX, kGap, kFoot));
  scene.place(lower, "lower_banister", rail, at(-inner, 0, 0));
  const int upper =
      scene.place(root, "upper_flight", flight, at(-kFlightX, kLanding, kTurn) * about_y(180));
  scene.place(upper, "upper_banister", rail, at(-inner, 0, 0));
  scene.place(root, "landing", scene.add_mesh(landing(kNorth, kTurn + 0.02)), at(0, kLanding, 0));
  scene.place(root, "upper_floor", scene.add_mesh(landing(kFoot, kSouth)), at(0, kUpper, 0));
}

void hang_pictures(ModelBuilder& scene, int root) {
  const int poster =
      scene.add_mesh(framed_picture(Finish::ridges_poster, {0.4, 0.6}, Finish::black_plastic));
  const int landscape = scene.add_mesh(framed_picture(Finish::painting, {0.8, 0.45}, Finish::oak));
  const int east = scene.add_group(root, "east_wall", at(kHalfX, 0, 0) * about_y(-90));
  const int west = scene.add_group(root, "west_wall", at(-kHalfX, 0, 0) * about_y(90));
  for (int i = 0; i < 4; ++i) {  // rising with the stairs
    const double along = 0.85 * (i - 1.5);
    const double rise = kFlight.rise / kFlight.going * along;
    scene.place(east, "east_picture_" + std::to_string(i), i % 2 == 0 ? poster : landscape,
                at(-along, 2.2 + rise, kGap), 0.9);
    scene.place(west, "west_picture_" + std::to_string(i), i % 2 == 0 ? landscape : poster,
                at(-along, 4.2 + rise, kGap), 0.9);
  }
  const int shapes = scene.add_mesh(pinned_picture(Finish::shapes_poster, {0.75, 1.05}));
  scene.place(root, "landing_picture", shapes, at(0.55, kLanding + 1.5, kNorth + kGap));
  scene.place(root, "clock", scene.add_mesh(wall_clock()), at(-0.5, kLanding + 1.8, kNorth + kGap));
}

void furnish(ModelBuilder& scene, int root) {
  scene.place(root, "landing_plant", scene.add_mesh(potted_plant()), at(-1.0, kLanding, -2.6), 0.9);
  scene.place(root, "doormat", scene.add_mesh(doormat()), at(0.5, kGap, 2.2));
  scene.place(root, "door", scene.add_mesh(door()), at(0.5, 0, kSouth) * about_y(180));
  const int shelf = scene.place(root, "sideboard", scene.add_mesh(sideboard()),
                                at(-1.17, kGap, 0.1) * about_y(90));
  scene.place(shelf, "books", scene.add_mesh(book_stack("book_stack", 5, 821)),
              at(0.3, 0.801, 0) * about_y(15));
  scene.place(shelf, "globe", scene.add_mesh(globe()), at(-0.4, 0.801, 0));
  scene.place(root, "basket", scene.add_mesh(basket()), at(-1.1, kGap, 2.2));
  scene.place(root, "box", scene.add_mesh(parcel({0.4, 0.3, 0.3})),
              at(0.9, kUpper, 2.2) * about_y(20));
}

void add_lamps(ModelBuilder& scene, int root) {
  const int lamp = scene.add_mesh(pendant_lamp());
  scene.place(root, "upper_lamp", lamp, at(0, kCeiling, -0.4));
  scene.add_light(root, {"upper_light", LightKind::point, {1, 0.93, 0.82}, 12},
                  at(0, kCeiling - kPendantDrop, -0.4));
  scene.place(root, "lower_lamp", lamp, at(0.2, kUpper - kSlab, 1.8));
  scene.add_light(root, {"lower_light", LightKind::point, {1, 0.88, 0.7}, 5},
                  at(0.2, kUpper - kSlab - kPendantDrop, 1.8));
}

}  // namespace

Model make_staircase() {
  ModelBuilder scene("staircase");
  const int root = scene.add_group(kNone, "staircase", Eigen::Isometry3d::Identity());
  scene.place(root, "stairwell", scene.add_mesh(stairwell()), Eigen::Isometry3d::Identity());
  add_stairs(scene, root);
  hang_pictures(scene, root);
  furnish(scene, root);
  add_lamps(scene, root);
  return scene.model();
}

}  // namespace scenes
