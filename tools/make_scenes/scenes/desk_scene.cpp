#include <string>

#include "tools/make_scenes/furniture/books.h"
#include "tools/make_scenes/furniture/clutter.h"
#include "tools/make_scenes/furniture/decoration.h"
#include "tools/make_scenes/furniture/desk_things.h"
#include "tools/make_scenes/furniture/fixtures.h"
#include "tools/make_scenes/furniture/lamps.h"
#include "tools/make_scenes/furniture/seating.h"
#include "tools/make_scenes/furniture/storage.h"
#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

constexpr double kHalfX = 1.7;     // m
constexpr double kHalfZ = 1.5;     // m
constexpr double kCeiling = 2.45;  // m
constexpr double kTop = 0.741;     // height of the worktop, m
constexpr double kGap = 0.001;     // m

Mesh study_shell() {
  return plain_shell({2 * kHalfX, kCeiling, 2 * kHalfZ},
                     {Finish::floor, Finish::ceiling, Finish::plain_wall, Finish::wallpaper,
                      Finish::brick, Finish::plain_wall});
}

void scatter_papers(ModelBuilder& scene, int desk) {
  const int page = scene.add_mesh(sheet_of_paper(Finish::page, 1));
  const int bent_page = scene.add_mesh(sheet_of_paper(Finish::page, 3));
  const int notes = scene.add_mesh(sheet_of_paper(Finish::handwriting, 2));
  struct Place {
    double x, z, turn;
    int mesh;
  };
  int count = 0;
  for (const Place& place : {Place{-0.28, 0.26, 8, page}, Place{-0.14, 0.22, -17, notes},
                             Place{0.36, 0.2, 24, bent_page}, Place{0.5, 0.27, -6, page},
                             Place{-0.72, 0.24, 31, notes}, Place{0.64, -0.02, 62, page},
                             Place{-0.44, 0.0, -35, bent_page}, Place{0.0, 0.27, 3, bent_page}}) {
    scene.place(desk, "sheet_" + std::to_string(count), place.mesh,
                at(place.x, kTop + 0.0006 * count, place.z) * about_y(place.turn));
    ++count;
  }
}

void set_up_desk(ModelBuilder& scene, int desk) {
  const double y = kTop + kGap;
  scene.place(desk, "monitor", scene.add_mesh(monitor()), at(0.08, y, -0.2) * about_y(-4));
  scene.place(desk, "keyboard", scene.add_mesh(keyboard()), at(0.06, y + 0.004, 0.1) * about_y(3));
  scene.place(desk, "mouse", scene.add_mesh(mouse()), at(0.42, y + 0.003, 0.08) * about_y(-12));
  scene.place(desk, "laptop", scene.add_mesh(laptop()), at(-0.52, y + 0.004, -0.14) * about_y(27));
  scene.place(desk, "lamp", scene.add_mesh(table_lamp()), at(0.78, y, -0.27));
  scene.place(desk, "pencil_pot", scene.add_mesh(pencil_pot()), at(-0.24, y, -0.1));
  scene.place(desk, "ruler", scene.add_mesh(ruler()), at(-0.1, y + 0.008, 0.33) * about_y(-13));
  scene.place(desk, "cube", scene.add_mesh(puzzle_cube()), at(0.3, y + 0.006, 0.3) * about_y(33));
  scene.place(desk, "chess", scene.add_mesh(chess_board()),
              at(-0.66, y + 0.006, 0.17) * about_y(9));
  const int white_cup = scene.add_mesh(cup({0.75, 0.73, 0.68}));
  const int blue_cup = scene.add_mesh(cup({0.1, 0.2, 0.4}));
  scene.place(desk, "white_cup", white_cup, at(-0.3, y + 0.006, 0.2) * about_y(40));
  scene.place(desk, "blue_cup", blue_cup, at(0.58, y, -0.1) * about_y(190));
  scene.place(desk, "bottle", scene.add_mesh(bottle()), at(0.5, y, -0.27));
  const int stack = scene.add_mesh(book_stack("book_stack", 5, 701));
  scene.place(desk, "stack", stack, at(0.7, y + 0.006, 0.18) * about_y(-18));
  scene.place(desk, "low_stack", scene.add_mesh(book_stack("low_book_stack", 3, 702)),
              at(-0.8, y, -0.24) * about_y(12));
  scene.place(desk, "open_book", scene.add_mesh(open_book()),
              at(0.12, y + 0.006, 0.29) * about_y(-14), 0.8);
  scene.place(desk, "plant", scene.add_mesh(small_plant()), at(-0.8, y + 0.11, -0.24));
  scene.place(desk, "packet", scene.add_mesh(packet({0.13, 0.19, 0.05}, {0.6, 0.25, 0.08})),
              at(-0.28, y, -0.28) * about_y(14));
}

void add_surroundings(ModelBuilder& scene, int root) {
  scene.place(root, "shell", scene.add_mesh(study_shell()), Eigen::Isometry3d::Identity());
  scene.place(root, "pinboard", scene.add_mesh(pinboard()), at(-0.25, 1.6, -kHalfZ));
  const int shelf =
      scene.place(root, "wall_shelf", scene.add_mesh(wall_shelf()), at(1.05, 1.55, -kHalfZ));
  scene.place(shelf, "shelf_books", scene.add_mesh(book_row("book_row", 0.72, 703)),
              at(-0.12, 0, 0.2));
  scene.place(shelf, "globe", scene.add_mesh(globe()), at(0.4, kGap, 0.12), 0.7);
  scene.place(root, "chair", scene.add_mesh(chair()), at(0.25, kGap, -0.25) * about_y(160));
  scene.place(root, "clock", scene.add_mesh(wall_clock()), at(-1.3, 1.95, -kHalfZ + kGap));
  const int picture = scene.add_mesh(framed_picture(Finish::painting, {0.9, 0.5}, Finish::oak));
  scene.place(root, "east_picture", picture, at(kHalfX - kGap, 1.5, -0.2) * about_y(-90));
  scene.place(root, "west_picture", picture, at(-kHalfX + kGap, 1.5, 0.1) * about_y(90));
  scene.place(root, "box", scene.add_mesh(parcel({0.5, 0.34, 0.38})),
              at(-1.2, kGap, 1.1) * about_y(20));
}

}  // namespace

Model make_desk() {
  ModelBuilder scene("desk");
  const int root = scene.add_group(kNone, "desk", Eigen::Isometry3d::Identity());
  add_surroundings(scene, root);
  const int desk =
      scene.place(root, "worktop", scene.add_mesh(worktop()), at(0, kGap, -kHalfZ + 0.42));
  scatter_papers(scene, desk);
  set_up_desk(scene, desk);
  scene.place(root, "pendant_lamp", scene.add_mesh(pendant_lamp()), at(0.2, kCeiling, 0.2));
  scene.add_light(root, {"pendant_light", LightKind::point, {1, 0.95, 0.86}, 6},
                  at(0.2, kCeiling - kPendantDrop, 0.2));
  scene.add_light(desk, {"desk_light", LightKind::point, {1, 0.86, 0.68}, 0.8},
                  at(0.78, kTop + 0.5, -0.22));
  return scene.model();
}

}  // namespace scenes
