#include "tools/make_scenes/furniture/decoration.h"

#include <cmath>
#include <numbers>
#include <string>

#include "tools/make_scenes/painting/noise.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

/// Returns a leaf from the origin along +z that rises and droops; `size` is (width, length), m.
Shape leaf(const Eigen::Vector2d& size, double droop) {
  const auto blade = [&](double u, double v) {
    const double side = 2 * u - 1;
    const double half =
        size.x() / 2 * (0.04 + 1.9 * std::sqrt(v + 0.001) * (1 - v) * (1 - 0.2 * v));
    return Vector3d(side * half, 0.25 * half * side * side - droop * size.y() * v * v,
                    size.y() * v);
  };
  return sheet(blade, {4, 6, {1, 1}});
}

void add_pot(Mesh& mesh, double radius) {
  const double h = 1.7 * radius;
  add(mesh, Finish::terracotta,
      lathe({{0, 0.002},
             {0.72 * radius, 0.002},
             {0.72 * radius, 0.002},
             {0.95 * radius, 0.8 * h},
             {0.95 * radius, 0.8 * h},
             {1.02 * radius, 0.8 * h},
             {1.02 * radius, 0.8 * h},
             {1.02 * radius, h},
             {1.02 * radius, h},
             {0.92 * radius, h},
             {0.92 * radius, h},
             {0.9 * radius, 0.86 * h}},
            28));
  add(mesh, Finish::soil, lathe({{0.905 * radius, 0.88 * h}, {0, 0.9 * h}}, 20));
}

void add_branch(Mesh& mesh, int branch, double height) {
  const double turn = 137.5 * branch;
  const double lean = 3 + 11 * random01(201, branch);
  const Eigen::Isometry3d stem = at(0, 0.28, 0) * about_y(turn) * about_x(lean);
  add(mesh, Finish::walnut, lathe({{0.009, 0}, {0.004, height}, {0, height}}, 8), stem);
  constexpr int kLeaves = 9;
  for (int i = 0; i < kLeaves; ++i) {
    const double y = height * (0.3 + 0.7 * i / (kLeaves - 1.0));
    const double length = 0.2 + 0.1 * random01(202, branch, i);
    add(mesh, Finish::leaf, leaf({0.48 * length, length}, 0.25 + 0.3 * random01(203, branch, i)),
        stem * at(0, y, 0) * about_y(137.5 * i + 60 * random01(204, branch, i)) *
            about_x(-35 + 30 * random01(205, branch, i)));
  }
}

}  // namespace

Mesh framed_picture(Finish picture, const Eigen::Vector2d& size, Finish frame) {
  constexpr double kBar = 0.028;
  Mesh mesh = {"framed_picture_" + std::to_string(static_cast<int>(picture)), {}};
  for (const double side : {-1.0, 1.0}) {
    add(mesh, frame, plank({kBar, size.y() + 2 * kBar, 0.03}, 0.005),
        at(side * (size.x() + kBar) / 2, 0, 0.016));
    add(mesh, frame, plank({size.x() - 0.001, kBar, 0.029}, 0.005),
        at(0, side * (size.y() + kBar) / 2, 0.016));
  }
  add(mesh, picture, panel(size.x() + 0.002, size.y() + 0.002), at(0, 0, 0.012));
  return mesh;
}

Mesh pinned_picture(Finish picture, const Eigen::Vector2d& size) {
  Mesh mesh = {"pinned_picture_" + std::to_string(static_cast<int>(picture)), {}};
  const auto paper = [&](double u, double v) {
    const double x = 2 * u - 1;
    const double y = 1 - 2 * v;
    return Vector3d(size.x() / 2 * x, size.y() / 2 * y,
                    0.003 + 0.012 * x * x * y * y * (1.2 - 0.5 * x));
  };
  add(mesh, picture, sheet(paper, {8, 8, {1, 1}}));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::brass, sphere(0.006, 8), at(side * 0.3 * size.x(), 0.47 * size.y(), 0.009));
  }
  return mesh;
}

Mesh wall_clock() {
  Mesh mesh = {"wall_clock", {}};
  add(mesh, Finish::black_plastic,
      lathe(
          {{0.16, 0}, {0.165, 0.012}, {0.16, 0.035}, {0.152, 0.04}, {0.146, 0.034}, {0.146, 0.018}},
          40),
      about_x(90));
  add(mesh, Finish::clock, disc(0.147, 40), at(0, 0, 0.016));
  return mesh;
}

Mesh rug() {
  Mesh mesh = {"rug", {}};
  Shape cloth = box({2.2, 0.009, 1.6}, 0.003);
  for (Eigen::Vector2d& texcoord : cloth.texcoords) {
    texcoord += Eigen::Vector2d(1.1, 0.8);
  }
  add(mesh, Finish::rug, cloth, at(0, 0.0055, 0));
  return mesh;
}

Mesh doormat() {
  Mesh mesh = {"doormat", {}};
  add(mesh, Finish::carpet, box({0.75, 0.014, 0.45}, 0.004), at(0, 0.008, 0));
  return mesh;
}

Mesh globe() {
  Mesh mesh = {"globe", {}};
  add(mesh, Finish::walnut,
      lathe({{0.1, 0.001},
             {0.1, 0.015},
             {0.1, 0.015},
             {0.07, 0.025},
             {0.02, 0.04},
             {0.014, 0.06},
             {0.014, 0.085},
             {0, 0.085}},
            24));
  add(mesh, Finish::globe, sphere(0.14, 36), at(0, 0.24, 0) * about_z(-23));
  const auto meridian = [](double u, double v) {
    const double around = 2 * std::numbers::pi * v;
    const double along = std::numbers::pi * (u - 0.5);
    const double radius = 0.152 + 0.005 * std::cos(around);
    return Vector3d(-radius * std::cos(along), radius * std::sin(along), 0.005 * std::sin(around));
  };
  add(mesh, Finish::brass, sheet(meridian, {24, 6, {1, 1}}), at(0, 0.24, 0) * about_z(-23));
  return mesh;
}

Mesh vase() {
  Mesh mesh = {"vase", {}};
  add(mesh, Finish::glaze,
      lathe({{0, 0.001},
             {0.045, 0.001},
             {0.06, 0.02},
             {0.09, 0.1},
             {0.08, 0.17},
             {0.04, 0.23},
             {0.035, 0.26},
             {0.05, 0.285},
             {0.046, 0.285},
             {0.031, 0.26},
             {0.034, 0.2},
             {0, 0.19}},
            28));
  for (int i = 0; i < 7; ++i) {
    const Eigen::Isometry3d stem = at(0, 0.2, 0) * about_y(51 * i) * about_x(5 + 3 * (i % 3));
    const double height = 0.26 + 0.03 * (i % 4);
    add(mesh, Finish::leaf, lathe({{0.003, 0}, {0.002, height}}, 6), stem);
    const Color petal = i % 2 == 0 ? Color(0.75, 0.28, 0.06) : Color(0.78, 0.62, 0.1);
    add(mesh, Finish::paint,
        painted(lathe({{0, -0.01}, {0.022, 0.004}, {0.03, 0.02}, {0.014, 0.016}, {0, 0.018}}, 12),
                petal),
        stem * at(0, height, 0));
  }
  return mesh;
}

Mesh potted_plant() {
  Mesh mesh = {"potted_plant", {}};
  add_pot(mesh, 0.19);
  for (int branch = 0; branch < 6; ++branch) {
    add_branch(mesh, branch, 0.75 + 0.45 * random01(206, branch));
  }
  return mesh;
}

Mesh small_plant() {
  Mesh mesh = {"small_plant", {}};
  add_pot(mesh, 0.065);
  for (int i = 0; i < 16; ++i) {
    const double length = 0.12 + 0.1 * random01(207, i);
    add(mesh, Finish::leaf, leaf({0.3 * length, length}, 0.5),
        at(0, 0.095, 0) * about_y(137.5 * i) * about_x(-75 + 55 * random01(208, i)));
  }
  return mesh;
}

}  // namespace scenes
