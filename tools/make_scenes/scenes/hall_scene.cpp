#include <string>
#include <vector>

#include "tools/make_scenes/furniture/architecture.h"
#include "tools/make_scenes/furniture/clutter.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/furniture/tables.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

constexpr double kHalfX = 3.5;    // m
constexpr double kHalfZ = 6.0;    // m
constexpr double kCeiling = 4.2;  // m
constexpr double kGap = 0.001;    // m
constexpr int kWindows = 4;
constexpr double kWindowEvery = 2.8;  // m
constexpr double kPaneWidth = 1.5;    // m
constexpr double kPaneBottom = 0.6;   // m
constexpr double kPaneHeight = 3.0;   // m
constexpr double kWallDepth = 0.3;    // m

double window_x(int window) {
  return kWindowEvery * (window - (kWindows - 1) / 2.0);
}

/// Adds the wall with the windows, whose x runs along it, and what is seen through them.
void add_window_wall(ModelBuilder& scene, int wall) {
  std::vector<Opening> openings;
  for (int i = 0; i < kWindows; ++i) {
    const double x = window_x(i);
    openings.push_back(
        {x - kPaneWidth / 2, x + kPaneWidth / 2, kPaneBottom, kPaneBottom + kPaneHeight});
  }
  scene.place(wall, "window_wall",
              scene.add_mesh(
                  pierced_wall({2 * kHalfZ, kCeiling}, openings, kWallDepth, Finish::plain_wall)),
              Eigen::Isometry3d::Identity());
  const int window = scene.add_mesh(tall_window(kPaneWidth, kPaneHeight));
  for (int i = 0; i < kWindows; ++i) {
    scene.place(wall, "window_" + std::to_string(i), window, at(window_x(i), kPaneBottom, -0.2));
  }
  scene.place(wall, "view", scene.add_mesh(view()), at(0, -0.5, -8), 2.5);
}

Mesh hall_shell() {
  Mesh mesh = {"shell", {}};
  const Eigen::Vector3d x(2 * kHalfX, 0, 0);
  const Eigen::Vector3d y(0, kCeiling, 0);
  const Eigen::Vector3d z(0, 0, 2 * kHalfZ);
  const Eigen::Vector3d corner(-kHalfX, 0, -kHalfZ);
  add(mesh, Finish::marble, rectangle(corner, x, z));
  add(mesh, Finish::ceiling, rectangle(corner + y + z, x, -z));
  add(mesh, Finish::wallpaper, rectangle(corner + y, x, -y));
  add(mesh, Finish::plain_wall, rectangle(corner + x + y + z, -x, -y));
  add(mesh, Finish::wallpaper, rectangle(corner + y + z, -z, -y));
  for (int i = 0; i < 7; ++i) {
    add(mesh, Finish::walnut, plank({2 * kHalfX, 0.22, 0.16}, 0.01),
        at(0, kCeiling - 0.09, 1.8 * (i - 3)));
  }
  return mesh;
}

void add_columns(ModelBuilder& scene, int root) {
  const int mesh = scene.add_mesh(column(kCeiling - 0.2));
  for (int i = 0; i < 4; ++i) {
    const double z = 3.0 * (i - 1.5);
    scene.place(root, "west_column_" + std::to_string(i), mesh, at(-1.9, kGap, z));
    scene.place(root, "east_column_" + std::to_string(i), mesh, at(1.9, kGap, z));
  }
}

void hang_pictures(ModelBuilder& scene, int west_wall, int north_wall) {
  const int painting = scene.add_mesh(framed_picture(Finish::painting, {1.1, 0.62}, Finish::oak));
  const int ridges =
      scene.add_mesh(framed_picture(Finish::ridges_poster, {0.7, 1.05}, Finish::brass));
  const int shapes =
      scene.add_mesh(framed_picture(Finish::shapes_poster, {0.75, 1.05}, Finish::walnut));
  const int map = scene.add_mesh(framed_picture(Finish::map, {1.6, 0.8}, Finish::walnut));
  int count = 0;
  for (const int mesh : {painting, ridges, map, shapes, painting}) {
    scene.place(west_wall, "picture_" + std::to_string(count), mesh,
                at(2.1 * (count - 2), 1.9, kGap));
    ++count;
  }
  scene.place(north_wall, "north_picture", map, at(0, 2.0, kGap), 1.3);
  scene.place(north_wall, "clock", scene.add_mesh(wall_clock()), at(0, 3.2, kGap), 1.6);
}

void furnish(ModelBuilder& scene, int root) {
  const int carpet = scene.add_mesh(rug());
  const int seat = scene.add_mesh(bench());
  const int plant = scene.add_mesh(potted_plant());
  for (int i = 0; i < 3; ++i) {
    const std::string name = std::to_string(i);
    scene.place(root, "rug_" + name, carpet, at(0, kGap, 3.2 * (i - 1)) * about_y(90), 1.25);
    scene.place(root, "west_bench_" + name, seat, at(-2.9, kGap, 3.0 * (i - 1)) * about_y(90));
    scene.place(root, "plant_" + name, plant, at(2.9, kGap, 2.8 * (i - 1)) * about_y(70.0 * i),
                1.1);
  }
  const int table = scene.place(root, "table", scene.add_mesh(dining_table()),
                                at(0.1, 0.013, -3.4) * about_y(90), 1.2);
  scene.place(table, "globe", scene.add_mesh(globe()), at(-0.4, 0.751, 0.05));
  scene.place(table, "vase", scene.add_mesh(vase()), at(0.1, 0.751, -0.1));
  scene.place(table, "fruit_bowl", scene.add_mesh(fruit_bowl()), at(0.45, 0.751, 0.05));
  scene.place(root, "chest", scene.add_mesh(parcel({0.9, 0.5, 0.55})), at(-2.7, kGap, -5.3));
}

void add_light(ModelBuilder& scene, int root) {
  const int lamp = scene.add_mesh(chandelier());
  for (const double z : {-2.7, 2.7}) {
    const std::string name = z < 0 ? "north" : "south";
    scene.place(root, name + "_chandelier", lamp, at(0, kCeiling, z));
    scene.add_light(root, {name + "_light", LightKind::point, {1, 0.88, 0.7}, 6},
                    at(0, kCeiling - kChandelierDrop + 0.15, z));
  }
  const Eigen::Vector3d travel = Eigen::Vector3d(-1, -1.3, 0.45).normalized();
  const auto turn = Eigen::Quaterniond::FromTwoVectors(-Eigen::Vector3d::UnitZ(), travel);
  scene.add_light(root, {"sun", LightKind::directional, {1, 0.95, 0.85}, 9},
                  at(12, 10, 0) * Eigen::Isometry3d(turn));
}

}  // namespace

Model make_hall() {
  ModelBuilder scene("hall");
  const int root = scene.add_group(kNone, "hall", Eigen::Isometry3d::Identity());
  const int east = scene.add_group(root, "east_wall", at(kHalfX, 0, 0) * about_y(-90));
  const int west = scene.add_group(root, "west_wall", at(-kHalfX, 0, 0) * about_y(90));
  const int north = scene.add_group(root, "north_wall", at(0, 0, -kHalfZ));
  const int south = scene.add_group(root, "south_wall", at(0, 0, kHalfZ) * about_y(180));
  scene.place(root, "shell", scene.add_mesh(hall_shell()), Eigen::Isometry3d::Identity());
  add_window_wall(scene, east);
  add_columns(scene, root);
  hang_pictures(scene, west, north);
  scene.place(south, "door", scene.add_mesh(door()), at(0, 0, 0), 1.2);
  furnish(scene, root);
  add_light(scene, root);
  return scene.model();
}

}  // namespace scenes
