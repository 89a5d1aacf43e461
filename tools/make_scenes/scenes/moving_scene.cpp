#include <cmath>
#include <numbers>

#include "tools/make_scenes/furniture/books.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/lamps.h"
#include "tools/make_scenes/furniture/seating.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/furniture/tables.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/model/periodic_motion.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kHalfX = 2.5;        // m
constexpr double kHalfZ = 2.0;        // m
constexpr double kCeiling = 2.6;      // m
constexpr double kDoorX = 1.2;        // m, centre of the doorway in the wall z = -kHalfZ
constexpr double kDoorWidth = 0.9;    // m
constexpr double kDoorHeight = 2.05;  // m
constexpr double kClosetDepth = 0.8;  // m
constexpr Period kPeriod = {.duration = 8, .steps = 160};
constexpr double kBallRadius = 0.14;  // m
constexpr double kGap = 0.001;        // m

/// Adds the wall with the doorway, and the closet behind it.
void add_doorway_wall(Mesh& mesh) {
  const double left = kDoorX - kDoorWidth / 2;
  const double right = kDoorX + kDoorWidth / 2;
  const auto piece = [&](double from, double to, double bottom, double top) {
    add(mesh, Finish::wallpaper,
        rectangle({from, top, -kHalfZ}, {to - from, 0, 0}, {0, bottom - top, 0}, {from, -top}));
  };
  piece(-kHalfX, left, 0, kCeiling);
  piece(right, kHalfX, 0, kCeiling);
  piece(left, right, kDoorHeight, kCeiling);
  const Vector3d in(0, 0, -kClosetDepth);
  const Vector3d along(kDoorWidth, 0, 0);
  const Vector3d up(0, kDoorHeight, 0);
  const Vector3d corner(left, 0, -kHalfZ);
  add(mesh, Finish::brick, rectangle(corner + in + up, along, -up));
  add(mesh, Finish::plain_wall, rectangle(corner + up, in, -up));
  add(mesh, Finish::plain_wall, rectangle(corner + along + in + up, -in, -up));
  add(mesh, Finish::floor, rectangle(corner + in, along, -in));
  add(mesh, Finish::plain_wall, rectangle(corner + up, along, in));
}

Mesh hall_shell() {
  Mesh mesh = plain_shell({2 * kHalfX, kCeiling, 2 * kHalfZ}, {.floor = Finish::floor,
                                                               .ceiling = Finish::ceiling,
                                                               .north = std::nullopt,
                                                               .east = Finish::plain_wall,
                                                               .south = Finish::brick,
                                                               .west = Finish::plain_wall});
  add_doorway_wall(mesh);
  return mesh;
}

/// Returns a door leaf from its hinges at the origin along +x, its middle in the plane z = 0.
Mesh door_leaf() {
  Mesh mesh = {"door_leaf", {}};
  const Isometry3d middle = at(kDoorWidth / 2, kDoorHeight / 2 + 0.004, 0);
  add(mesh, Finish::door_paint, box({kDoorWidth - 0.012, kDoorHeight - 0.014, 0.04}, 0.004),
      middle);
  for (const double turn : {0.0, 180.0}) {
    const Isometry3d face = middle * about_y(turn);
    add(mesh, Finish::shapes_poster, panel(0.5, 0.7), face * at(0, 0.38, 0.0205));
    add(mesh, Finish::white_paint, box({0.6, 0.62, 0.012}, 0.004), face * at(0, -0.5, 0.024));
    const double side = turn == 0 ? 1 : -1;
    add(mesh, Finish::brass, cylinder(0.009, 0.06, 10),
        face * at(side * 0.38, 0.03, 0.02) * about_x(90));
    add(mesh, Finish::brass, sphere(0.026, 14), face * at(side * 0.38, 0.03, 0.085));
  }
  return mesh;
}

/// Returns a ball whose image goes around once and from pole to pole.
Mesh ball() {
  Mesh mesh = {"ball", {}};
  Shape shape = sphere(kBallRadius, 36);
  for (Eigen::Vector2d& texcoord : shape.texcoords) {
    texcoord = texcoord.cwiseQuotient(Eigen::Vector2d(2, 1) * std::numbers::pi * kBallRadius);
  }
  add(mesh, Finish::ball, shape);
  return mesh;
}

/// Returns a crate on four wheels, which do not turn.
Mesh crate() {
  Mesh mesh = {"crate", {}};
  constexpr double kSize = 0.4;
  const Isometry3d middle = at(0, kSize / 2 + 0.05, 0);
  add(mesh, Finish::pine, box(Vector3d::Constant(kSize - 0.004), 0.004), middle);
  for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
    add(mesh, Finish::crate, panel(kSize, kSize), middle * about_y(turn) * at(0, 0, kSize / 2));
  }
  add(mesh, Finish::crate, panel(kSize, kSize), middle * about_x(-90) * at(0, 0, kSize / 2));
  for (const double x : {-0.14, 0.14}) {
    for (const double z : {-0.21, 0.19}) {
      add(mesh, Finish::black_plastic, cylinder(0.05, 0.02, 20), at(x, 0.052, z) * about_x(90));
    }
  }
  return mesh;
}

void add_moving_things(ModelBuilder& scene, int root) {
  const int leaf =
      scene.place(root, "door_leaf", scene.add_mesh(door_leaf()), Isometry3d::Identity());
  scene.add_motion(periodic_motion(leaf, kPeriod, [](double phase) {
    return at(kDoorX - kDoorWidth / 2, 0, -kHalfZ + 0.025) * about_y(-40 * (1 - std::cos(phase)));
  }));
  const int ball_node = scene.place(root, "ball", scene.add_mesh(ball()), Isometry3d::Identity());
  scene.add_motion(periodic_motion(ball_node, kPeriod, [](double phase) {
    const double x = 1.5 * std::cos(phase);
    const double turn_deg = -x / kBallRadius * 180 / std::numbers::pi;  // rolling without slip
    return at(x, kBallRadius + kGap, 0.1) * about_z(turn_deg);
  }));
  const int crate_node =
      scene.place(root, "crate", scene.add_mesh(crate()), Isometry3d::Identity());
  scene.add_motion(periodic_motion(crate_node, kPeriod, [](double phase) {
    return at(-1.5, kGap, -0.8 - 0.7 * std::sin(phase)) * about_y(15 * std::sin(2 * phase));
  }));
}

void furnish(ModelBuilder& scene, int root) {
  scene.place(root, "shell", scene.add_mesh(hall_shell()), Isometry3d::Identity());
  const Isometry3d east = at(kHalfX, 0, 0) * about_y(-90);
  const Isometry3d west = at(-kHalfX, 0, 0) * about_y(90);
  scene.place(root, "sideboard", scene.add_mesh(sideboard()), east * at(0.2, kGap, 0.235));
  scene.place(root, "globe", scene.add_mesh(globe()), east * at(-0.2, 0.802, 0.25));
  scene.place(root, "books", scene.add_mesh(book_stack("book_stack", 5, 801)),
              east * at(0.5, 0.802, 0.25) * about_y(15));
  scene.place(root, "map", scene.add_mesh(framed_picture(Finish::map, {1.2, 0.6}, Finish::oak)),
              east * at(0.2, 1.7, kGap));
  scene.place(root, "coast",
              scene.add_mesh(framed_picture(Finish::painting, {1.1, 0.62}, Finish::walnut)),
              west * at(-0.3, 1.6, kGap));
  scene.place(root, "poster", scene.add_mesh(pinned_picture(Finish::ridges_poster, {0.6, 0.9})),
              at(-0.4, 1.55, -kHalfZ + kGap));
  scene.place(root, "clock", scene.add_mesh(wall_clock()), at(0.35, 2.1, -kHalfZ + kGap));
  scene.place(root, "rug", scene.add_mesh(rug()), at(0.6, kGap, 0.9));
  scene.place(root, "chair", scene.add_mesh(chair()), at(-1.9, kGap, 1.2) * about_y(110));
  scene.place(root, "plant", scene.add_mesh(potted_plant()), at(2.0, kGap, -1.5));
  scene.place(root, "box", scene.add_mesh(parcel({0.5, 0.34, 0.38})),
              at(-0.6, kGap, 1.6) * about_y(8));
}

}  // namespace

Model make_moving_room() {
  ModelBuilder scene("moving_room");
  const int root = scene.add_group(kNone, "moving_room", Isometry3d::Identity());
  furnish(scene, root);
  add_moving_things(scene, root);
  scene.place(root, "pendant_lamp", scene.add_mesh(pendant_lamp()), at(0.2, kCeiling, 0.3));
  scene.add_light(root, {"pendant_light", LightKind::point, {1, 0.94, 0.84}, 11},
                  at(0.2, kCeiling - kPendantDrop, 0.3));
  scene.add_light(root, {"lamp_light", LightKind::point, {0.9, 0.95, 1}, 3}, at(-1.8, 2.3, -1.0));
  return scene.model();
}

}  // namespace scenes
