#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/lamps.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

constexpr double kHalfX = 2.0;       // m
constexpr double kHalfZ = 1.75;      // m
constexpr double kCeiling = 2.5;     // m
constexpr double kDoorWidth = 0.95;  // m, including the frame

Mesh white_shell() {
  return plain_shell({2 * kHalfX, kCeiling, 2 * kHalfZ},
                     {Finish::white_floor, Finish::white_wall, Finish::white_wall,
                      Finish::white_wall, Finish::white_wall, Finish::white_wall});
}

Mesh white_table() {
  Mesh mesh = {"table", {}};
  add(mesh, Finish::white_wall, box({1.2, 0.04, 0.7}, 0.006), at(0, 0.72, 0));
  for (const double x : {-0.54, 0.54}) {
    for (const double z : {-0.29, 0.29}) {
      add(mesh, Finish::white_wall, box({0.06, 0.7, 0.06}, 0.006), at(x, 0.35, z));
    }
  }
  return mesh;
}

Mesh white_stool() {
  Mesh mesh = {"stool", {}};
  add(mesh, Finish::white_wall, cylinder(0.18, 0.04, 32), at(0, 0.42, 0));
  add(mesh, Finish::white_wall, cylinder(0.03, 0.42, 16));
  add(mesh, Finish::white_wall, lathe({{0.16, 0}, {0.16, 0.015}, {0.03, 0.03}}, 32));
  return mesh;
}

Mesh white_shelf() {
  Mesh mesh = {"shelf", {}};
  for (const double x : {-0.45, 0.45}) {
    add(mesh, Finish::white_wall, box({0.03, 1.8, 0.32}, 0.004), at(x, 0.9, 0));
  }
  for (const double y : {0.06, 0.48, 0.92, 1.36, 1.78}) {
    add(mesh, Finish::white_wall, box({0.88, 0.03, 0.318}, 0.004), at(0, y, 0));
  }
  add(mesh, Finish::white_wall, box({0.88, 1.76, 0.01}), at(0, 0.9, -0.15));
  return mesh;
}

Mesh white_pillar() {
  Mesh mesh = {"pillar", {}};
  add(mesh, Finish::white_wall, cylinder(0.16, kCeiling, 40));
  return mesh;
}

Mesh white_things() {
  Mesh mesh = {"things", {}};
  add(mesh, Finish::white_wall, sphere(0.11, 32), at(-0.3, 0.112, 0));
  add(mesh, Finish::white_wall, box({0.2, 0.2, 0.2}, 0.006), at(0.15, 0.101, 0.08) * about_y(25));
  add(mesh, Finish::white_wall, lathe({{0.09, 0.001}, {0, 0.26}}, 32), at(0.4, 0, -0.12));
  return mesh;
}

void furnish(ModelBuilder& scene, int root) {
  scene.place(root, "shell", scene.add_mesh(white_shell()), Eigen::Isometry3d::Identity());
  const int table = scene.place(root, "table", scene.add_mesh(white_table()), at(0.6, 0, -0.7));
  scene.place(table, "things", scene.add_mesh(white_things()), at(0, 0.741, 0));
  const int stool = scene.add_mesh(white_stool());
  scene.place(root, "left_stool", stool, at(0.2, 0, -0.05));
  scene.place(root, "right_stool", stool, at(1.45, 0, -0.4));
  scene.place(root, "shelf", scene.add_mesh(white_shelf()), at(-1.2, 0, -kHalfZ + 0.17));
  scene.place(root, "pillar", scene.add_mesh(white_pillar()), at(-1.45, 0, 0.9));
  scene.place(root, "door", scene.add_mesh(door()), at(0.5, 0, kHalfZ) * about_y(180));
  scene.place(root, "light_switch", scene.add_mesh(light_switch()),
              at(0.5 - kDoorWidth, 1.1, kHalfZ) * about_y(180));
  scene.place(root, "skirting", scene.add_mesh(skirting(2 * kHalfX)), at(0, 0, -kHalfZ));
}

}  // namespace

Model make_white_room() {
  ModelBuilder scene("white_room");
  const int root = scene.add_group(kNone, "white_room", Eigen::Isometry3d::Identity());
  furnish(scene, root);
  scene.place(root, "pendant_lamp", scene.add_mesh(pendant_lamp()), at(0.1, kCeiling, 0.1));
  scene.add_light(root, {"pendant_light", LightKind::point, {1, 0.96, 0.9}, 10},
                  at(0.1, kCeiling - kPendantDrop, 0.1));
  scene.add_light(root, {"second_light", LightKind::point, {0.9, 0.95, 1}, 4}, at(1.2, 2.1, 1.1));
  return scene.model();
}

}  // namespace scenes
