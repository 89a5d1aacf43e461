#include <string>

#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

constexpr int kModules = 8;
constexpr double kModule = 3.0;   // length of a module along z, m
constexpr double kHalfX = 1.1;    // m
constexpr double kCeiling = 2.6;  // m
constexpr double kDado = 1.05;    // m above the floor
constexpr double kEnd = kModules * kModule / 2;

/// Returns one module of floor, ceiling and walls from z = 0 on.
Mesh module_shell() {
  Mesh mesh = {"module_shell", {}};
  const Vector3d x(2 * kHalfX, 0, 0);
  const Vector3d z(0, 0, kModule);
  const Vector3d left(-kHalfX, 0, 0);
  const Vector3d right(kHalfX, 0, 0);
  const Vector3d dado(0, kDado, 0);
  const Vector3d top(0, kCeiling, 0);
  add(mesh, Finish::linoleum, rectangle(left, x, z));
  add(mesh, Finish::ceiling_panels, rectangle(left + top + z, x, -z));
  add(mesh, Finish::plain_wall, rectangle(left + top + z, -z, dado - top));
  add(mesh, Finish::wallpaper, rectangle(left + dado + z, -z, -dado));
  add(mesh, Finish::plain_wall, rectangle(right + top, z, dado - top));
  add(mesh, Finish::wallpaper, rectangle(right + dado, z, -dado));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::oak, plank({0.02, 0.06, kModule}, 0.004),
        at(side * (kHalfX - 0.005), kDado, kModule / 2));
    add(mesh, Finish::black_plastic, box({0.02, 0.09, kModule}, 0.003),
        at(side * (kHalfX - 0.005), 0.045, kModule / 2));
  }
  return mesh;
}

/// Returns an office door, its back at z = 0, the floor at y = 0.
Mesh office_door() {
  Mesh mesh = {"office_door", {}};
  add(mesh, Finish::door_paint, box({0.9, 2.05, 0.03}, 0.003), at(0, 1.026, 0.004));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::grey_plastic, box({0.06, 2.12, 0.05}, 0.004), at(side * 0.48, 1.06, 0.015));
  }
  add(mesh, Finish::grey_plastic, box({0.9, 0.06, 0.05}, 0.004), at(0, 2.09, 0.015));
  add(mesh, Finish::steel, box({0.035, 0.18, 0.01}, 0.003), at(-0.37, 1.02, 0.024));
  add(mesh, Finish::steel, cylinder(0.009, 0.13, 12), at(-0.375, 1.05, 0.06) * about_z(-90));
  add(mesh, Finish::steel, box({0.8, 0.22, 0.004}), at(0, 0.15, 0.021));
  add(mesh, Finish::print, panel(0.16, 0.1), at(0, 1.55, 0.0205));
  return mesh;
}

Mesh ceiling_lamp() {
  Mesh mesh = {"ceiling_lamp", {}};
  add(mesh, Finish::steel, box({0.34, 0.05, 1.24}, 0.006), at(0, -0.02, 0));
  add(mesh, Finish::lamp_glow, box({0.28, 0.02, 1.18}, 0.004), at(0, -0.045, 0));
  return mesh;
}

Mesh exit_sign() {
  Mesh mesh = {"exit_sign", {}};
  add(mesh, Finish::grey_plastic, box({0.38, 0.2, 0.04}, 0.004));
  for (const double turn : {0.0, 180.0}) {
    add(mesh, Finish::exit_sign, panel(0.36, 0.18), about_y(turn) * at(0, 0, 0.0205));
  }
  add(mesh, Finish::steel, cylinder(0.006, 0.3, 8), at(0, 0.1, 0));
  return mesh;
}

Mesh end_wall() {
  Mesh mesh = {"end_wall", {}};
  add(mesh, Finish::plain_wall,
      rectangle({-kHalfX, kCeiling, 0}, {2 * kHalfX, 0, 0}, {0, -kCeiling, 0}));
  return mesh;
}

/// Indices of the meshes that every module repeats.
struct Repeated {
  int shell, door, lamp, sign, picture, board;
};

void add_module(ModelBuilder& scene, int root, const Repeated& meshes, int index) {
  const std::string name = "module_" + std::to_string(index);
  const int node = scene.add_group(root, name, at(0, 0, index * kModule - kEnd));
  scene.place(node, name + "_shell", meshes.shell, Eigen::Isometry3d::Identity());
  scene.place(node, name + "_lamp", meshes.lamp, at(0, kCeiling, kModule / 2));
  const Eigen::Isometry3d on_left = at(-kHalfX, 0, 0.8) * about_y(90);
  const Eigen::Isometry3d on_right = at(kHalfX, 0, 0.8) * about_y(-90);
  scene.place(node, name + "_left_door", meshes.door, on_left);
  scene.place(node, name + "_right_door", meshes.door, on_right);
  scene.place(node, name + "_left_picture", meshes.picture, on_left * at(-1.4, 1.62, 0.001));
  scene.place(node, name + "_right_board", meshes.board, on_right * at(1.35, 1.6, 0.001));
}

/// Adds the two end walls, the only places that can be distinguished.
void add_ends(ModelBuilder& scene, int root) {
  const int wall = scene.add_mesh(end_wall());
  const int north = scene.place(root, "north_end", wall, at(0, 0, -kEnd));
  const int south = scene.place(root, "south_end", wall, at(0, 0, kEnd) * about_y(180));
  scene.place(north, "north_poster",
              scene.add_mesh(pinned_picture(Finish::shapes_poster, {0.9, 1.26})),
              at(0.1, 1.55, 0.001));
  scene.place(north, "plant", scene.add_mesh(potted_plant()), at(-0.7, 0.001, 0.4));
  scene.place(south, "south_door", scene.add_mesh(door()), at(0, 0, 0));
}

}  // namespace

Model make_corridor() {
  ModelBuilder scene("corridor");
  const int root = scene.add_group(kNone, "corridor", Eigen::Isometry3d::Identity());
  const Repeated meshes = {
      .shell = scene.add_mesh(module_shell()),
      .door = scene.add_mesh(office_door()),
      .lamp = scene.add_mesh(ceiling_lamp()),
      .sign = scene.add_mesh(exit_sign()),
      .picture = scene.add_mesh(framed_picture(Finish::ridges_poster, {0.5, 0.75}, Finish::oak)),
      .board = scene.add_mesh(framed_picture(Finish::map, {0.8, 0.4}, Finish::black_plastic))};
  for (int index = 0; index < kModules; ++index) {
    add_module(scene, root, meshes, index);
  }
  for (const double z : {-6.0, 0.0, 6.0}) {
    const std::string name = z < 0 ? "north" : z > 0 ? "south" : "middle";
    scene.place(root, name + "_exit_sign", meshes.sign, at(0, 2.22, z));
  }
  add_ends(scene, root);
  for (int lamp = 0; lamp < kModules; lamp += 2) {
    const double z = (lamp + 1) * kModule - kEnd;
    scene.add_light(root, {"lamp_" + std::to_string(lamp), LightKind::point, {1, 0.97, 0.9}, 4},
                    at(0, kCeiling - 0.12, z));
  }
  return scene.model();
}

}  // namespace scenes
