#include <string>

#include "tools/make_scenes/furniture/books.h"
#include "tools/make_scenes/furniture/clutter.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/kitchen_things.h"
#include "tools/make_scenes/furniture/seating.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

constexpr double kHalfX = 2.0;       // m
constexpr double kHalfZ = 2.2;       // m
constexpr double kCeiling = 2.5;     // m
constexpr double kGap = 0.001;       // m
constexpr double kGlassWidth = 2.4;  // m, of the window that the north wall is but for its edges
constexpr double kGlassHeight = 2.2;

/// The groups of the scene graph. A wall's x runs along it to the right as seen from inside, y up
/// from the floor and z into the room.
struct Groups {
  int root, north_wall, east_wall, south_wall, west_wall;
};

Groups add_groups(ModelBuilder& scene) {
  const int root = scene.add_group(kNone, "kitchen", Eigen::Isometry3d::Identity());
  return {.root = root,
          .north_wall = scene.add_group(root, "north_wall", at(0, 0, -kHalfZ)),
          .east_wall = scene.add_group(root, "east_wall", at(kHalfX, 0, 0) * about_y(-90)),
          .south_wall = scene.add_group(root, "south_wall", at(0, 0, kHalfZ) * about_y(180)),
          .west_wall = scene.add_group(root, "west_wall", at(-kHalfX, 0, 0) * about_y(90))};
}

/// Returns floor, ceiling and walls with an opening for the window.
Mesh kitchen_shell() {
  Mesh mesh = plain_shell({2 * kHalfX, kCeiling, 2 * kHalfZ}, {Finish::tiles,
                                                               Finish::ceiling,
                                                               {},
                                                               Finish::wallpaper,
                                                               Finish::plain_wall,
                                                               Finish::plain_wall});
  const double side = kHalfX - kGlassWidth / 2;
  for (const double left : {-kHalfX, kGlassWidth / 2}) {
    add(mesh, Finish::plain_wall,
        rectangle({left, kCeiling, -kHalfZ}, {side, 0, 0}, {0, -kCeiling, 0}, {left, 0}));
  }
  add(mesh, Finish::plain_wall,
      rectangle({-kGlassWidth / 2, kCeiling, -kHalfZ}, {kGlassWidth, 0, 0},
                {0, kGlassHeight - kCeiling, 0}, {-kGlassWidth / 2, 0}));
  return mesh;
}

Mesh tiled_strip() {
  Mesh mesh = {"tiled_strip", {}};
  add(mesh, Finish::tiles, rectangle({-1.5, 0.6, 0}, {3.0, 0, 0}, {0, -0.6, 0}));
  return mesh;
}

void add_window(ModelBuilder& scene, const Groups& groups) {
  const int glass = scene.add_mesh(patio_window(kGlassWidth, kGlassHeight));
  const int window = scene.place(groups.north_wall, "patio_window", glass, at(0, 0, -0.03));
  scene.place(window, "view", scene.add_mesh(view()), at(0, 1.2, -4));
  scene.place(groups.north_wall, "window_plant", scene.add_mesh(potted_plant()),
              at(1.5, kGap, 0.45), 0.9);
}

void fill_cabinet(ModelBuilder& scene, int cabinet, const std::string& name, int cup_mesh,
                  int plate_mesh) {
  for (int i = 0; i < 4; ++i) {
    const std::string end = name + "_" + std::to_string(i);
    scene.place(cabinet, "cup_" + end, cup_mesh,
                at(-0.33 + 0.13 * i, kCabinetShelf + kGap, 0.2) * about_y(35.0 * i));
    scene.place(cabinet, "plate_" + end, plate_mesh, at(-0.2, kCabinetFloor + 0.012 * i, 0.17));
  }
  scene.place(cabinet, "books_" + name, scene.add_mesh(book_row("books_" + name, 0.3, 811)),
              at(0.24, kCabinetFloor, 0.24));
}

void add_counter(ModelBuilder& scene, const Groups& groups, int cup_mesh, int plate_mesh) {
  const int wall = groups.west_wall;
  const int top = scene.place(wall, "counter", scene.add_mesh(counter()), at(0, kGap, 0.32));
  scene.place(wall, "tiled_strip", scene.add_mesh(tiled_strip()), at(0, kCounterTop, kGap));
  scene.place(wall, "splashback", scene.add_mesh(splashback()), at(0.6, kCounterTop, 0.003));
  scene.place(wall, "hood", scene.add_mesh(hood()), at(0.6, 1.6, kGap));
  scene.place(wall, "fridge", scene.add_mesh(fridge()), at(-1.85, kGap, 0.34));
  const int cabinet = scene.add_mesh(glass_cabinet());
  fill_cabinet(scene, scene.place(wall, "left_cabinet", cabinet, at(-0.33, 1.5, kGap)), "left",
               cup_mesh, plate_mesh);
  fill_cabinet(scene, scene.place(wall, "right_cabinet", cabinet, at(1.54, 1.5, kGap)), "right",
               cup_mesh, plate_mesh);
  const double y = kCounterTop + kGap;
  const int pot = scene.add_mesh(cooking_pot());
  scene.place(top, "pot", pot, at(0.46, y + 0.007, 0.12) * about_y(20));
  scene.place(top, "small_pot", pot, at(0.74, y + 0.007, -0.12) * about_y(70), 0.75);
  scene.place(top, "cereal", scene.add_mesh(packet({0.19, 0.29, 0.06}, {0.12, 0.3, 0.5})),
              at(-0.25, y, -0.12) * about_y(12));
  scene.place(top, "counter_bottle", scene.add_mesh(bottle()), at(0.05, y, -0.18));
  scene.place(top, "counter_plant", scene.add_mesh(small_plant()), at(1.3, y, -0.05));
  scene.place(top, "counter_cup", cup_mesh, at(0.15, y, 0.1) * about_y(-40));
  scene.place(top, "recipe", scene.add_mesh(open_book()), at(-0.32, y, 0.12) * about_y(18), 0.8);
}

void add_table(ModelBuilder& scene, const Groups& groups, int cup_mesh, int plate_mesh) {
  constexpr double kTop = 0.751;
  const int table = scene.place(groups.root, "glass_table", scene.add_mesh(glass_table()),
                                at(0.5, kGap, -0.6) * about_y(-12));
  const int glass = scene.add_mesh(wine_glass());
  scene.place(table, "left_plate", plate_mesh, at(-0.3, kTop, 0.2));
  scene.place(table, "right_plate", plate_mesh, at(0.32, kTop, -0.2));
  scene.place(table, "left_glass", glass, at(-0.1, kTop, 0.22));
  scene.place(table, "right_glass", glass, at(0.1, kTop, -0.24));
  scene.place(table, "third_glass", glass, at(0.42, kTop, 0.12));
  scene.place(table, "table_cup", cup_mesh, at(-0.46, kTop, 0.05) * about_y(80));
  scene.place(table, "fruit_bowl", scene.add_mesh(fruit_bowl()), at(0.03, kTop, 0));
  const int seat = scene.add_mesh(chair());
  scene.place(table, "west_chair", seat, at(-0.85, 0, 0.05) * about_y(88));
  scene.place(table, "east_chair", seat, at(0.88, 0, -0.08) * about_y(-94));
  scene.place(table, "north_chair", seat, at(0.2, 0, -0.6) * about_y(4));
  scene.place(table, "south_chair", seat, at(-0.25, 0, 0.62) * about_y(172));
}

void add_other_walls(ModelBuilder& scene, const Groups& groups) {
  const int board =
      scene.place(groups.east_wall, "sideboard", scene.add_mesh(sideboard()), at(0.5, kGap, 0.235));
  scene.place(board, "sideboard_books", scene.add_mesh(book_stack("book_stack", 4, 812)),
              at(-0.4, 0.801, 0.05) * about_y(14));
  scene.place(board, "sideboard_vase", scene.add_mesh(vase()), at(0.3, 0.801, 0));
  scene.place(groups.east_wall, "picture",
              scene.add_mesh(framed_picture(Finish::painting, {0.9, 0.5}, Finish::oak)),
              at(0.5, 1.6, kGap));
  scene.place(groups.east_wall, "clock", scene.add_mesh(wall_clock()), at(-0.7, 1.9, kGap));
  scene.place(groups.east_wall, "map", scene.add_mesh(pinned_picture(Finish::map, {0.7, 0.35})),
              at(-1.3, 1.45, kGap));
  scene.place(groups.south_wall, "door", scene.add_mesh(door()), at(-1.2, 0, 0));
  scene.place(groups.south_wall, "light_switch", scene.add_mesh(light_switch()), at(-0.5, 1.1, 0));
  scene.place(groups.south_wall, "mirror", scene.add_mesh(wall_mirror()), at(0.6, 1.35, kGap));
}

}  // namespace

Model make_kitchen() {
  ModelBuilder scene("kitchen");
  const Groups groups = add_groups(scene);
  const int cup_mesh = scene.add_mesh(cup({0.75, 0.3, 0.2}));
  const int plate_mesh = scene.add_mesh(plate());
  scene.place(groups.root, "shell", scene.add_mesh(kitchen_shell()), Eigen::Isometry3d::Identity());
  add_window(scene, groups);
  add_counter(scene, groups, cup_mesh, plate_mesh);
  add_table(scene, groups, cup_mesh, plate_mesh);
  add_other_walls(scene, groups);
  scene.place(groups.root, "ceiling_light", scene.add_mesh(ceiling_light()), at(0, kCeiling, 0));
  return scene.model();
}

}  // namespace scenes
