#include "tools/make_scenes/furniture/desk_things.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "tools/make_scenes/painting/noise.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

constexpr double kPageWidth = 0.21;    // width of A4, m
constexpr double kPageHeight = 0.297;  // height of A4, m

Shape pencil() {
  Shape shape = painted(cylinder(0.0038, 0.15, 6), {0.75, 0.5, 0.05});
  append(shape, painted(lathe({{0.0038, 0.15}, {0.001, 0.165}, {0, 0.168}}, 6), {0.6, 0.42, 0.25}),
         Eigen::Isometry3d::Identity());
  return shape;
}

Shape pen(const Color& color) {
  Shape shape = painted(cylinder(0.005, 0.13, 10), color);
  append(shape, painted(lathe({{0.0052, 0.13}, {0.0052, 0.142}, {0, 0.144}}, 10), color * 0.3),
         Eigen::Isometry3d::Identity());
  return shape;
}

Shape pawn() {
  return lathe({{0.015, 0.001},
                {0.015, 0.006},
                {0.008, 0.012},
                {0.006, 0.03},
                {0.011, 0.034},
                {0.011, 0.042},
                {0.006, 0.05},
                {0, 0.053}},
               16);
}

}  // namespace

Mesh worktop() {
  Mesh mesh = {"worktop", {}};
  for (int board = 0; board < 4; ++board) {
    add(mesh, Finish::oak, plank({1.8, 0.035, 0.198 + 0.0003 * board}, 0.003),
        at(0, 0.7225, 0.2 * (board - 1.5)));
  }
  for (const double x : {-0.82, 0.82}) {
    for (const double z : {-0.33, 0.33}) {
      add(mesh, Finish::steel, box({0.05, 0.704, 0.05}, 0.005), at(x, 0.353, z));
    }
  }
  return mesh;
}

Mesh sheet_of_paper(Finish print, int bent) {
  Mesh mesh = {"sheet_" + std::to_string(static_cast<int>(print)) + "_" + std::to_string(bent), {}};
  const double lift = 0.004 + 0.007 * bent;
  const auto paper = [&](double u, double v) {
    const double corner = std::max(0.0, u - v);
    return Vector3d(kPageWidth * (u - 0.5), 0.0008 + lift * corner * corner * corner,
                    kPageHeight * (v - 0.5));
  };
  add(mesh, print, sheet(paper, {8, 10, {1, 1}}));
  return mesh;
}

Mesh pencil_pot() {
  Mesh mesh = {"pencil_pot", {}};
  add(mesh, Finish::glaze,
      lathe({{0, 0.001}, {0.04, 0.001}, {0.04, 0.001}, {0.042, 0.1}, {0.039, 0.1}, {0.037, 0.01}},
            24));
  const std::array<Color, 3> inks = {Color(0.05, 0.1, 0.5), Color(0.5, 0.04, 0.04),
                                     Color(0.02, 0.02, 0.02)};
  for (int i = 0; i < 7; ++i) {
    const double turn = 51 * i + 20 * random01(601, i);
    const Eigen::Isometry3d place =
        about_y(turn) * at(0, 0.012, -0.02) * about_x(9 + 4 * random01(602, i));
    add(mesh, Finish::paint, i < 4 ? pencil() : pen(inks.at(static_cast<std::size_t>(i - 4))),
        place);
  }
  return mesh;
}

Mesh ruler() {
  Mesh mesh = {"ruler", {}};
  add(mesh, Finish::paint, painted(box({0.32, 0.0025, 0.04}), {0.6, 0.6, 0.55}), at(0, 0.0016, 0));
  add(mesh, Finish::ruler, panel(0.32, 0.04), at(0, 0.003, 0) * about_x(-90));
  return mesh;
}

Mesh puzzle_cube() {
  Mesh mesh = {"puzzle_cube", {}};
  constexpr double kCell = 0.019;
  const std::array<Color, 6> stickers = {Color(0.6, 0.05, 0.04),  Color(0.05, 0.3, 0.1),
                                         Color(0.04, 0.12, 0.5),  Color(0.8, 0.65, 0.05),
                                         Color(0.75, 0.25, 0.03), Color(0.8, 0.8, 0.78)};
  const Eigen::Isometry3d centre = at(0, 1.5 * kCell + 0.001, 0);
  add(mesh, Finish::paint, painted(box(Vector3d::Constant(3 * kCell), 0.002), {0.01, 0.01, 0.01}),
      centre);
  const std::array<Eigen::Isometry3d, 6> sides = {about_y(0),   about_y(90), about_y(180),
                                                  about_y(-90), about_x(90), about_x(-90)};
  for (int side = 0; side < 6; ++side) {
    for (int cell = 0; cell < 9; ++cell) {
      const auto color = static_cast<std::size_t>(6 * random01(611, side, cell));
      const int column = cell % 3 - 1;
      const int row = cell / 3 - 1;
      Shape sticker = panel(0.016, 0.016);
      add(mesh, Finish::paint, painted(sticker, stickers.at(color)),
          centre * sides.at(static_cast<std::size_t>(side)) *
              at(kCell * column, kCell * row, 1.5 * kCell + 0.0004));
    }
  }
  return mesh;
}

Mesh mouse() {
  Mesh mesh = {"mouse", {}};
  add(mesh, Finish::grey_plastic, soft_box({0.06, 0.034, 0.105}, 0.016), at(0, 0.018, 0));
  add(mesh, Finish::rust_fabric, box({0.22, 0.003, 0.18}, 0.001), at(0.01, 0.0018, 0.01));
  return mesh;
}

Mesh chess_board() {
  Mesh mesh = {"chess_board", {}};
  add(mesh, Finish::walnut, box({0.4, 0.018, 0.4}, 0.003), at(0, 0.01, 0));
  add(mesh, Finish::checker, panel(0.396, 0.396), at(0, 0.0195, 0) * about_x(-90));
  constexpr double kSquare = 0.396 * 0.88 / 8;
  for (int i = 0; i < 14; ++i) {
    const int column = static_cast<int>(8 * random01(621, i)) - 4;
    const int row = i < 7 ? static_cast<int>(3 * random01(622, i)) - 4
                          : static_cast<int>(3 * random01(622, i)) + 1;
    const Color color = i < 7 ? Color(0.03, 0.02, 0.015) : Color(0.75, 0.65, 0.45);
    add(mesh, Finish::paint, painted(pawn(), color),
        at(kSquare * (column + 0.5), 0.019, kSquare * (row + 0.5)));
  }
  return mesh;
}

Mesh pinboard() {
  Mesh mesh = {"pinboard", {}};
  add(mesh, Finish::cork, box({1.2, 0.8, 0.014}), at(0, 0, 0.008));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::oak, plank({0.03, 0.86, 0.024}), at(side * 0.615, 0, 0.013));
    add(mesh, Finish::oak, plank({1.2, 0.03, 0.023}), at(0, side * 0.415, 0.013));
  }
  constexpr std::array<Finish, 9> kPrints = {
      Finish::page, Finish::handwriting,   Finish::painting,
      Finish::page, Finish::map,           Finish::shapes_poster,
      Finish::page, Finish::ridges_poster, Finish::handwriting};
  for (int i = 0; i < static_cast<int>(kPrints.size()); ++i) {
    const Finish print = kPrints.at(static_cast<std::size_t>(i));
    const bool wide = print == Finish::painting || print == Finish::map;
    const double x = -0.46 + 0.23 * (i % 5) + 0.03 * (random01(631, i) - 0.5);
    const double y = (i < 5 ? 0.19 : -0.18) + 0.06 * (random01(632, i) - 0.5);
    const Eigen::Isometry3d place =
        at(x + (i < 5 ? 0 : 0.12), y, 0.0165 + 0.0012 * i) * about_z(12 * (random01(633, i) - 0.5));
    const Shape paper = wide ? panel(0.2, 0.12) : panel(kPageWidth * 0.95, kPageHeight * 0.95);
    add(mesh, print, paper, place);
    add(mesh, Finish::paint, painted(sphere(0.007, 10), {0.6, 0.05, 0.05}),
        place * at(0, wide ? 0.05 : 0.13, 0.004));
  }
  return mesh;
}

}  // namespace scenes
