#include <array>
#include <cstddef>
#include <string>

#include "tools/make_scenes/furniture/books.h"
#include "tools/make_scenes/furniture/clutter.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/lamps.h"
#include "tools/make_scenes/furniture/seating.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/furniture/tables.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

constexpr double kGap = 0.001;  // m, between a thing and the surface below it

/// Indices of the meshes that are placed several times.
struct SharedMeshes {
  int chair, short_row, long_row, other_row, stack, low_stack, small_plant, white_cup, blue_cup;
  int bottle, vase, table_lamp, plate, poster, landscape;
};

/// The groups of the scene graph. A wall's x runs along it to the right as seen from inside, y up
/// from the floor and z into the room.
struct Groups {
  int building, north_wall, east_wall, south_wall, west_wall, dining, lounge, lights;
};

Groups add_groups(ModelBuilder& room) {
  const int root = room.add_group(kNone, "room", Eigen::Isometry3d::Identity());
  const auto group = [&](const std::string& name, const Eigen::Isometry3d& T_room_group) {
    return room.add_group(root, name, T_room_group);
  };
  return {.building = group("building", Eigen::Isometry3d::Identity()),
          .north_wall = group("north_wall", at(0, 0, -kHalfDepth)),
          .east_wall = group("east_wall", at(kHalfWidth, 0, 0) * about_y(-90)),
          .south_wall = group("south_wall", at(0, 0, kHalfDepth) * about_y(180)),
          .west_wall = group("west_wall", at(-kHalfWidth, 0, 0) * about_y(90)),
          .dining = group("dining", at(1.75, kGap, 0.55)),
          .lounge = group("lounge", at(-0.95, kGap, 0.3) * about_y(90)),
          .lights = group("lights", Eigen::Isometry3d::Identity())};
}

SharedMeshes add_shared_meshes(ModelBuilder& room) {
  return {.chair = room.add_mesh(chair()),
          .short_row = room.add_mesh(book_row("short_book_row", 0.36, 301)),
          .long_row = room.add_mesh(book_row("long_book_row", 0.72, 302)),
          .other_row = room.add_mesh(book_row("other_book_row", 0.7, 303)),
          .stack = room.add_mesh(book_stack("book_stack", 5, 304)),
          .low_stack = room.add_mesh(book_stack("low_book_stack", 3, 305)),
          .small_plant = room.add_mesh(small_plant()),
          .white_cup = room.add_mesh(cup({0.75, 0.73, 0.68})),
          .blue_cup = room.add_mesh(cup({0.1, 0.2, 0.4})),
          .bottle = room.add_mesh(bottle()),
          .vase = room.add_mesh(vase()),
          .table_lamp = room.add_mesh(table_lamp()),
          .plate = room.add_mesh(plate()),
          .poster = room.add_mesh(
              framed_picture(Finish::ridges_poster, {0.4, 0.6}, Finish::black_plastic)),
          .landscape = room.add_mesh(framed_picture(Finish::painting, {1.1, 0.62}, Finish::oak))};
}

void add_building(ModelBuilder& room, const Groups& groups) {
  room.place(groups.building, "shell", room.add_mesh(shell()), Eigen::Isometry3d::Identity());
  const int long_skirting = room.add_mesh(skirting(5.96));
  const int short_skirting = room.add_mesh(skirting(4.95));
  room.place(groups.north_wall, "north_skirting", long_skirting, at(0, 0, 0));
  room.place(groups.east_wall, "east_skirting", short_skirting, at(0, 0, 0));
  room.place(groups.west_wall, "west_skirting", short_skirting, at(0, 0, 0));
  room.place(groups.south_wall, "south_skirting", room.add_mesh(skirting(4.74)), at(0.61, 0, 0));
  room.place(groups.building, "pendant_lamp", room.add_mesh(pendant_lamp()),
             at(-0.1, kHeight, 0.3));
}

void fill_bookcase(ModelBuilder& room, int bookcase, const SharedMeshes& meshes) {
  const std::array<std::array<int, 2>, 5> rows = {{{meshes.long_row, meshes.other_row},
                                                   {meshes.other_row, meshes.short_row},
                                                   {meshes.short_row, meshes.long_row},
                                                   {meshes.long_row, meshes.short_row},
                                                   {meshes.short_row, meshes.other_row}}};
  const std::array<int, 5> beside = {meshes.stack, meshes.vase, meshes.small_plant, meshes.blue_cup,
                                     meshes.low_stack};
  for (std::size_t shelf = 0; shelf < rows.size(); ++shelf) {
    for (std::size_t column = 0; column < 2; ++column) {
      const std::string name = std::to_string(shelf) + (column == 0 ? "_left" : "_right");
      const int row = rows.at(shelf).at(column);
      const double x = (column == 0 ? -1 : 1) * kBookcaseColumn;
      const double y = kShelfHeights.at(shelf);
      const bool half = row == meshes.short_row;
      room.place(bookcase, "books_" + name, row, at(half ? x - 0.17 : x, y, 0.12));
      if (half) {
        const bool stack = beside.at(shelf) == meshes.stack || beside.at(shelf) == meshes.low_stack;
        room.place(bookcase, "beside_books_" + name, beside.at(shelf),
                   at(x + 0.2, y + kGap, stack ? 0.09 : 0), shelf == 1 ? 0.7 : 1);
      }
    }
  }
}

void add_bookcase(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  const int case_node =
      room.place(groups.north_wall, "bookcase", room.add_mesh(bookcase()), at(-2.05, kGap, 0.18));
  fill_bookcase(room, case_node, meshes);
  room.place(case_node, "box_on_top", room.add_mesh(parcel({0.4, 0.22, 0.26})),
             at(-0.4, 2.05, 0) * about_y(6));
  room.place(case_node, "stack_on_top", meshes.low_stack, at(0.2, 2.05, 0.1) * about_y(-10));
  room.place(case_node, "plant_on_top", meshes.small_plant, at(0.58, 2.05, 0));
}

void add_desk(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  constexpr double kTop = 0.75 + kGap;
  const int desk_node =
      room.place(groups.north_wall, "desk", room.add_mesh(desk()), at(-0.15, kGap, 0.36));
  room.place(desk_node, "monitor", room.add_mesh(monitor()), at(0.05, kTop, -0.14));
  room.place(desk_node, "keyboard", room.add_mesh(keyboard()), at(0.03, kTop, 0.14) * about_y(3));
  room.place(desk_node, "laptop", room.add_mesh(laptop()), at(-0.45, kTop, 0.04) * about_y(24));
  room.place(desk_node, "desk_books", meshes.stack, at(0.52, kTop, -0.08) * about_y(-14));
  room.place(desk_node, "desk_cup", meshes.blue_cup, at(0.36, kTop, 0.17) * about_y(-40));
  room.place(groups.north_wall, "desk_chair", meshes.chair, at(-0.35, kGap, 0.9) * about_y(168));
  const int shelf =
      room.place(groups.north_wall, "wall_shelf", room.add_mesh(wall_shelf()), at(-0.15, 1.6, 0));
  room.place(shelf, "shelf_books", meshes.short_row, at(-0.3, 0, 0.2));
  room.place(shelf, "shelf_plant", meshes.small_plant, at(0.08, kGap, 0.11) * about_y(70));
  room.place(shelf, "shelf_cup", meshes.white_cup, at(0.27, kGap, 0.12) * about_y(20));
  room.place(shelf, "shelf_bottle", meshes.bottle, at(0.42, kGap, 0.1));
  room.place(groups.north_wall, "clock", room.add_mesh(wall_clock()), at(-0.1, 2.22, kGap));
  room.place(groups.north_wall, "small_poster", meshes.poster, at(-0.98, 1.55, kGap), 0.8);
}

void add_sideboard(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  constexpr double kTop = 0.8 + kGap;
  const int board =
      room.place(groups.north_wall, "sideboard", room.add_mesh(sideboard()), at(1.55, kGap, 0.235));
  room.place(board, "globe", room.add_mesh(globe()), at(-0.5, kTop, 0.02) * about_y(-30));
  room.place(board, "sideboard_books", meshes.low_stack, at(-0.1, kTop, 0.08) * about_y(8));
  room.place(board, "sideboard_vase", meshes.vase, at(0.22, kTop, -0.05));
  room.place(board, "sideboard_lamp", meshes.table_lamp, at(0.58, kTop, 0));
  room.place(board, "sideboard_cup", meshes.white_cup, at(0.36, kTop, 0.1) * about_y(200));
  room.place(groups.north_wall, "large_poster",
             room.add_mesh(pinned_picture(Finish::shapes_poster, {0.6, 0.84})),
             at(1.0, 1.78, kGap));
  room.place(groups.north_wall, "framed_poster", meshes.poster, at(1.7, 1.72, kGap));
  room.place(groups.north_wall, "framed_landscape", meshes.landscape, at(2.3, 1.95, kGap), 0.45);
  room.place(groups.north_wall, "framed_coast", meshes.landscape, at(2.3, 1.52, kGap), 0.45);
  room.place(groups.north_wall, "potted_plant", room.add_mesh(potted_plant()),
             at(2.48, kGap, 0.92));
}

void add_window(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  const int opening =
      room.place(groups.east_wall, "window", room.add_mesh(window()), at(kWindowZ, kWindowSill, 0));
  room.place(opening, "sill_plant", meshes.small_plant, at(-0.6, 0.032, 0.06) * about_y(150));
  room.place(opening, "sill_bottle", meshes.bottle, at(0.55, 0.032, 0.07));
  room.place(opening, "view", room.add_mesh(view()), at(4, 0.05, -3.5));
  room.place(groups.east_wall, "radiator", room.add_mesh(radiator()), at(kWindowZ, 0.27, 0));
  const int drape = room.add_mesh(curtain());
  room.place(groups.east_wall, "left_curtain", drape, at(kWindowZ - 1.1, 2.39, 0.12));
  room.place(groups.east_wall, "right_curtain", drape, at(kWindowZ + 1.1, 2.39, 0.12));
  room.place(groups.east_wall, "curtain_rod", room.add_mesh(curtain_rod()),
             at(kWindowZ, 2.39, 0.12));
}

void add_south_wall(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  room.place(groups.south_wall, "door", room.add_mesh(door()), at(-2.3, 0, 0));
  room.place(groups.south_wall, "doormat", room.add_mesh(doormat()), at(-2.3, kGap, 0.4));
  room.place(groups.south_wall, "light_switch", room.add_mesh(light_switch()), at(-1.66, 1.1, 0));
  room.place(groups.south_wall, "south_picture", meshes.landscape, at(1.75, 1.62, kGap), 0.5);
  const int box = room.add_mesh(parcel({0.5, 0.34, 0.38}));
  const int crate =
      room.place(groups.south_wall, "moving_box", box, at(0.75, kGap, 0.27) * about_y(5));
  room.place(groups.south_wall, "other_moving_box", box, at(0.1, kGap, 0.33) * about_y(-22), 0.8);
  room.place(crate, "packet_on_box", room.add_mesh(packet({0.2, 0.3, 0.07}, {0.7, 0.45, 0.1})),
             at(-0.05, 0.343, 0) * about_y(15));
  room.place(groups.south_wall, "basket", room.add_mesh(basket()), at(1.5, kGap, 0.28));
}

void add_sofa(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  const int sofa_node =
      room.place(groups.west_wall, "sofa", room.add_mesh(sofa()), at(-0.3, kGap, 0.48));
  const int ochre = room.add_mesh(cushion(Finish::ochre_fabric));
  const int linen = room.add_mesh(cushion(Finish::linen));
  room.place(sofa_node, "left_cushion", ochre,
             at(-0.56, 0.665, -0.03) * about_y(18) * about_x(-20));
  room.place(sofa_node, "middle_cushion", linen,
             at(0.25, 0.665, -0.02) * about_y(-8) * about_x(-22) * about_z(4));
  room.place(sofa_node, "right_cushion", ochre, at(0.58, 0.66, 0.07) * about_y(-30) * about_x(-24));
  const int side = room.place(groups.west_wall, "side_table", room.add_mesh(side_table()),
                              at(0.95, kGap, 0.35) * about_y(4));
  room.place(side, "side_lamp", meshes.table_lamp, at(-0.05, 0.5, -0.06));
  room.place(side, "side_cup", meshes.white_cup, at(0.11, 0.5, 0.1) * about_y(-60));
  room.place(groups.west_wall, "painting", meshes.landscape, at(-0.1, 1.62, kGap));
  room.place(groups.west_wall, "map", room.add_mesh(pinned_picture(Finish::map, {0.9, 0.45})),
             at(-1.45, 1.6, kGap));
  room.place(groups.west_wall, "west_poster", meshes.poster, at(1.25, 1.6, kGap));
  room.place(groups.west_wall, "floor_lamp", room.add_mesh(floor_lamp()), at(-1.9, kGap, 0.6));
}

void add_lounge(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  constexpr double kTop = 0.42 + kGap;
  room.place(groups.lounge, "rug", room.add_mesh(rug()), at(0, 0, 0));
  const int table =
      room.place(groups.lounge, "coffee_table", room.add_mesh(coffee_table()), at(0, 0.011, 0));
  room.place(table, "fruit_bowl", room.add_mesh(fruit_bowl()), at(0.12, kTop, -0.04));
  room.place(table, "table_books", meshes.low_stack, at(-0.33, kTop, 0.2) * about_y(-20));
  room.place(table, "open_book", room.add_mesh(open_book()), at(-0.06, kTop, 0.14) * about_y(28));
  room.place(table, "table_cup", meshes.white_cup, at(0.38, kTop, 0.14) * about_y(110));
  room.place(table, "lower_books", meshes.stack, at(0.2, 0.15, 0.12) * about_y(12));
  room.place(groups.lounge, "building_blocks", room.add_mesh(building_blocks()),
             at(-0.78, 0.012, 0.42));
}

void add_dining(ModelBuilder& room, const Groups& groups, const SharedMeshes& meshes) {
  constexpr double kTop = 0.75 + kGap;
  const int table =
      room.place(groups.dining, "dining_table", room.add_mesh(dining_table()), about_y(90));
  room.place(groups.dining, "west_chair", meshes.chair, at(-0.5, 0, -0.32) * about_y(88));
  room.place(groups.dining, "pulled_chair", meshes.chair, at(-0.66, 0, 0.4) * about_y(66));
  room.place(groups.dining, "east_chair", meshes.chair, at(0.52, 0, 0.15) * about_y(-93));
  room.place(groups.dining, "south_chair", meshes.chair, at(0.05, 0, 0.92) * about_y(184));
  room.place(table, "west_plate", meshes.plate, at(0.32, kTop, -0.24));
  room.place(table, "east_plate", meshes.plate, at(-0.15, kTop, 0.24));
  room.place(table, "dining_cup", meshes.blue_cup, at(0.12, kTop, -0.26) * about_y(60));
  room.place(table, "dining_bottle", meshes.bottle, at(0.05, kTop, 0.03));
  room.place(table, "dining_vase", meshes.vase, at(0.33, kTop, 0.08) * about_y(40));
  const int packet_mesh = room.add_mesh(packet({0.19, 0.29, 0.06}, {0.12, 0.3, 0.5}));
  room.place(table, "cereal", packet_mesh, at(-0.36, kTop, -0.06) * about_y(-70));
  room.place(table, "tea", packet_mesh, at(-0.52, kTop, 0.1) * about_y(-115), 0.55);
}

void add_lights(ModelBuilder& room, const Groups& groups) {
  room.add_light(groups.lights, {"pendant_light", LightKind::point, {1, 0.9, 0.76}, 13},
                 at(-0.1, kHeight - kPendantDrop, 0.3));
  room.add_light(groups.lights, {"floor_lamp_light", LightKind::point, {1, 0.84, 0.64}, 1.8},
                 at(-kHalfWidth + 0.6, kFloorLampLight, 1.9));
  const Eigen::Vector3d travel = Eigen::Vector3d(-1, -1.3, 0.25).normalized();
  const auto turn = Eigen::Quaterniond::FromTwoVectors(-Eigen::Vector3d::UnitZ(), travel);
  room.add_light(groups.lights, {"sun", LightKind::directional, {1, 0.96, 0.88}, 4},
                 at(6, 6, 0) * Eigen::Isometry3d(turn));
}

}  // namespace

Model make_room() {
  ModelBuilder room("room");
  const Groups groups = add_groups(room);
  const SharedMeshes meshes = add_shared_meshes(room);
  add_building(room, groups);
  add_bookcase(room, groups, meshes);
  add_desk(room, groups, meshes);
  add_sideboard(room, groups, meshes);
  add_window(room, groups, meshes);
  add_south_wall(room, groups, meshes);
  add_sofa(room, groups, meshes);
  add_lounge(room, groups, meshes);
  add_dining(room, groups, meshes);
  add_lights(room, groups);
  return room.model();
}

}  // namespace scenes
