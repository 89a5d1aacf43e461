#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "tools/make_scenes/furniture/books.h"
#include "tools/make_scenes/furniture/clutter.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/lamps.h"
#include "tools/make_scenes/furniture/seating.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"
#include "tools/make_scenes/scenes/visitor.h"

namespace scenes {
namespace {

using Eigen::Isometry3d;

constexpr double kHalfX = 2.6;    // m
constexpr double kHalfZ = 2.1;    // m
constexpr double kCeiling = 2.6;  // m
constexpr double kGap = 0.001;    // m

/// Indices of the meshes that are placed several times.
struct SharedMeshes {
  int long_row, short_row, stack, small_plant, poster, landscape;
};

SharedMeshes add_shared_meshes(ModelBuilder& scene) {
  return {
      .long_row = scene.add_mesh(book_row("long_book_row", 0.72, 901)),
      .short_row = scene.add_mesh(book_row("short_book_row", 0.4, 902)),
      .stack = scene.add_mesh(book_stack("book_stack", 4, 903)),
      .small_plant = scene.add_mesh(small_plant()),
      .poster =
          scene.add_mesh(framed_picture(Finish::ridges_poster, {0.4, 0.6}, Finish::black_plastic)),
      .landscape = scene.add_mesh(framed_picture(Finish::painting, {1.1, 0.62}, Finish::walnut))};
}

Mesh lounge_shell() {
  return plain_shell({2 * kHalfX, kCeiling, 2 * kHalfZ}, {.floor = Finish::carpet,
                                                          .ceiling = Finish::ceiling,
                                                          .north = Finish::brick,
                                                          .east = Finish::wallpaper,
                                                          .south = Finish::plain_wall,
                                                          .west = Finish::wallpaper});
}

void add_bookcase(ModelBuilder& scene, int north, const SharedMeshes& meshes) {
  const int case_node =
      scene.place(north, "bookcase", scene.add_mesh(bookcase()), at(-1.55, kGap, 0.18));
  for (std::size_t shelf = 0; shelf < kShelfHeights.size(); ++shelf) {
    const double y = kShelfHeights.at(shelf);
    const double way = shelf % 2 == 0 ? 1 : -1;
    const std::string number = std::to_string(shelf);
    scene.place(case_node, "long_row_" + number, meshes.long_row,
                at(way * kBookcaseColumn, y, 0.12));
    scene.place(case_node, "short_row_" + number, meshes.short_row,
                at(-way * kBookcaseColumn - 0.16, y, 0.12));
    scene.place(case_node, "beside_row_" + number, shelf == 2 ? meshes.small_plant : meshes.stack,
                at(-way * kBookcaseColumn + 0.21, y + kGap, shelf == 2 ? 0 : 0.09));
  }
  scene.place(case_node, "plant_on_top", meshes.small_plant, at(0.5, 2.05, 0));
}

void add_north_wall(ModelBuilder& scene, int root, const SharedMeshes& meshes) {
  const int north = scene.add_group(root, "north_wall", at(0, 0, -kHalfZ));
  add_bookcase(scene, north, meshes);
  constexpr double kTop = 0.8 + kGap;
  const int board =
      scene.place(north, "sideboard", scene.add_mesh(sideboard()), at(0.35, kGap, 0.235));
  scene.place(board, "globe", scene.add_mesh(globe()), at(-0.5, kTop, 0.02) * about_y(-30));
  scene.place(board, "sideboard_books", meshes.stack, at(-0.1, kTop, 0.08) * about_y(8));
  scene.place(board, "vase", scene.add_mesh(vase()), at(0.22, kTop, -0.05));
  scene.place(board, "table_lamp", scene.add_mesh(table_lamp()), at(0.58, kTop, 0));
  scene.place(north, "map", scene.add_mesh(framed_picture(Finish::map, {1.0, 0.5}, Finish::oak)),
              at(0.1, 1.78, kGap));
  scene.place(north, "poster", meshes.poster, at(1.0, 1.65, kGap));
  scene.place(north, "clock", scene.add_mesh(wall_clock()), at(1.55, 2.05, kGap));
  scene.place(north, "plant", scene.add_mesh(potted_plant()), at(1.75, kGap, 0.4));
  scene.place(north, "pinned_poster",
              scene.add_mesh(pinned_picture(Finish::shapes_poster, {0.6, 0.84})),
              at(2.05, 1.45, kGap));
}

void add_east_wall(ModelBuilder& scene, int root, const SharedMeshes& meshes) {
  const int east = scene.add_group(root, "east_wall", at(kHalfX, 0, 0) * about_y(-90));
  scene.place(east, "painting", meshes.landscape, at(-0.5, 1.6, kGap));
  scene.place(east, "east_poster", meshes.poster, at(0.6, 1.55, kGap));
  const int shelf =
      scene.place(east, "wall_shelf", scene.add_mesh(wall_shelf()), at(-0.4, 1.05, 0));
  scene.place(shelf, "shelf_books", meshes.long_row, at(-0.1, 0, 0.2));
  scene.place(shelf, "shelf_plant", meshes.small_plant, at(0.42, kGap, 0.11));
  scene.place(east, "chair", scene.add_mesh(chair()), at(-0.9, kGap, 0.6) * about_y(25));
  scene.place(east, "box", scene.add_mesh(parcel({0.5, 0.34, 0.38})),
              at(0.1, kGap, 0.3) * about_y(-8));
}

void add_others(ModelBuilder& scene, int root, const SharedMeshes& meshes) {
  const int west = scene.add_group(root, "west_wall", at(-kHalfX, 0, 0) * about_y(90));
  scene.place(west, "west_painting", meshes.landscape, at(0.2, 1.6, kGap));
  scene.place(west, "basket", scene.add_mesh(basket()), at(0.5, kGap, 0.3));
  const int south = scene.add_group(root, "south_wall", at(0, 0, kHalfZ) * about_y(180));
  scene.place(south, "door", scene.add_mesh(door()), at(-1.2, 0, 0));
  scene.place(south, "light_switch", scene.add_mesh(light_switch()), at(-0.5, 1.1, 0));
}

void add_lights(ModelBuilder& scene, int root) {
  scene.place(root, "pendant_lamp", scene.add_mesh(pendant_lamp()), at(0.3, kCeiling, 0.9));
  scene.add_light(root, {"pendant_light", LightKind::point, {1, 0.94, 0.84}, 9},
                  at(0.3, kCeiling - kPendantDrop, 0.9));
  scene.add_light(root, {"west_light", LightKind::point, {0.9, 0.95, 1}, 4}, at(-1.6, 2.3, 0.4));
  scene.add_light(root, {"north_light", LightKind::point, {1, 0.95, 0.88}, 3}, at(0.8, 2.4, -1.0));
}

}  // namespace

Model make_visited_room() {
  ModelBuilder scene("visited_room");
  const int root = scene.add_group(kNone, "visited_room", Isometry3d::Identity());
  const SharedMeshes meshes = add_shared_meshes(scene);
  scene.place(root, "shell", scene.add_mesh(lounge_shell()), Isometry3d::Identity());
  add_north_wall(scene, root, meshes);
  add_east_wall(scene, root, meshes);
  add_others(scene, root, meshes);
  add_lights(scene, root);
  add_visitor(scene, scene.add_group(root, "walk", at(0, kGap, 0.2) * about_y(90)));
  return scene.model();
}

}  // namespace scenes
