#include <string>
#include <vector>

#include "tools/make_scenes/furniture/architecture.h"
#include "tools/make_scenes/furniture/clutter.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/seating.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/furniture/tables.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

constexpr double kHalfX = 5.0;      // m
constexpr double kHalfZ = 6.0;      // m
constexpr double kWallTop = 3.6;    // m
constexpr double kWallDepth = 0.3;  // m
constexpr double kGap = 0.001;      // m
constexpr double kPaneWidth = 1.2;
constexpr double kPaneBottom = 0.9;
constexpr double kPaneHeight = 1.9;

/// Returns what hangs behind a window, as large as its opening.
Mesh drape() {
  Mesh mesh = {"drape", {}};
  add(mesh, Finish::linen, panel(kPaneWidth, kPaneHeight));
  return mesh;
}

/// Meshes that several walls show.
struct WallMeshes {
  int window, drape;
};

/// Adds a wall with evenly spaced windows and a coping on top; x runs along it.
void add_wall(ModelBuilder& scene, int wall, double length, int windows, Finish finish,
              const WallMeshes& meshes) {
  std::vector<Opening> openings;
  const double every = length / windows;
  for (int i = 0; i < windows; ++i) {
    const double x = every * (i - (windows - 1) / 2.0);
    openings.push_back(
        {x - kPaneWidth / 2, x + kPaneWidth / 2, kPaneBottom, kPaneBottom + kPaneHeight});
    scene.place(wall, "window_" + std::to_string(i), meshes.window, at(x, kPaneBottom, -0.15));
    scene.place(wall, "drape_" + std::to_string(i), meshes.drape,
                at(x, kPaneBottom + kPaneHeight / 2, 0.01 - kWallDepth));
  }
  Mesh mesh = pierced_wall({length, kWallTop}, openings, kWallDepth, finish);
  add(mesh, Finish::marble, box({length + 0.6, 0.08, 0.5}, 0.01), at(0, kWallTop + 0.04, -0.2));
  add(mesh, finish, box({length + 0.6, kWallTop, 0.02}), at(0, kWallTop / 2, -0.01 - kWallDepth));
  scene.place(wall, "wall", scene.add_mesh(mesh), Eigen::Isometry3d::Identity());
}

void add_walls(ModelBuilder& scene, int root) {
  const WallMeshes meshes = {scene.add_mesh(tall_window(kPaneWidth, kPaneHeight)),
                             scene.add_mesh(drape())};
  const int north = scene.add_group(root, "north_wall", at(0, 0, -kHalfZ));
  const int east = scene.add_group(root, "east_wall", at(kHalfX, 0, 0) * about_y(-90));
  const int south = scene.add_group(root, "south_wall", at(0, 0, kHalfZ) * about_y(180));
  const int west = scene.add_group(root, "west_wall", at(-kHalfX, 0, 0) * about_y(90));
  add_wall(scene, north, 2 * kHalfX, 3, Finish::brick, meshes);
  add_wall(scene, east, 2 * kHalfZ, 4, Finish::plain_wall, meshes);
  add_wall(scene, south, 2 * kHalfX, 2, Finish::plain_wall, meshes);
  add_wall(scene, west, 2 * kHalfZ, 4, Finish::brick, meshes);
  scene.place(south, "door", scene.add_mesh(door()), at(0, 0, 0), 1.1);
}

Mesh ground() {
  Mesh mesh = {"ground", {}};
  add(mesh, Finish::tiles,
      rectangle({-kHalfX, 0, -kHalfZ}, {2 * kHalfX, 0, 0}, {0, 0, 2 * kHalfZ}));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::soil, box({1.4, 0.03, 8}), at(side * 3.9, 0.015, 0));
  }
  return mesh;
}

void add_garden(ModelBuilder& scene, int root) {
  scene.place(root, "fountain", scene.add_mesh(fountain()), at(0, kGap, -1.2));
  const int tall = scene.add_mesh(tree(3.4));
  const int box = scene.add_mesh(planter());
  const int seat = scene.add_mesh(bench());
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? "west" : "east";
    scene.place(root, name + "_north_tree", tall, at(side * 3.7, kGap, -3.4) * about_y(80 * side));
    scene.place(root, name + "_south_tree", tall, at(side * 3.9, kGap, 2.4) * about_y(30 * side),
                0.8);
    scene.place(root, name + "_bench", seat, at(side * 2.6, kGap, -0.6) * about_y(-90 * side));
    scene.place(root, name + "_planter", box, at(side * 1.7, kGap, -5.5));
    scene.place(root, name + "_low_planter", box, at(side * 2.9, kGap, 3.6) * about_y(90), 0.9);
  }
  scene.place(root, "potted_plant", scene.add_mesh(potted_plant()), at(-1.1, kGap, 5.3));
}

void add_table(ModelBuilder& scene, int root) {
  const int table =
      scene.place(root, "table", scene.add_mesh(dining_table()), at(-1.9, kGap, 1.6) * about_y(20));
  const int seat = scene.add_mesh(chair());
  scene.place(table, "west_chair", seat, at(-0.95, 0, 0) * about_y(90));
  scene.place(table, "north_chair", seat, at(0.1, 0, -0.65) * about_y(4));
  scene.place(table, "south_chair", seat, at(-0.1, 0, 0.7) * about_y(190));
  scene.place(table, "bowl", scene.add_mesh(fruit_bowl()), at(0, 0.751, 0));
  scene.place(table, "cup", scene.add_mesh(cup({0.1, 0.2, 0.4})), at(-0.4, 0.751, 0.15));
  scene.place(root, "crate", scene.add_mesh(parcel({0.6, 0.45, 0.45})),
              at(2.2, kGap, 5.4) * about_y(-14));
}

}  // namespace

Model make_courtyard() {
  ModelBuilder scene("courtyard");
  const int root = scene.add_group(kNone, "courtyard", Eigen::Isometry3d::Identity());
  scene.place(root, "ground", scene.add_mesh(ground()), Eigen::Isometry3d::Identity());
  add_walls(scene, root);
  add_garden(scene, root);
  add_table(scene, root);
  return scene.model();
}

}  // namespace scenes
