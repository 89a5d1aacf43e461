#include "tools/make_scenes/furniture/tables.h"

namespace scenes {
namespace {

void add_legs(Mesh& mesh, Finish finish, const Eigen::Vector3d& leg, double half_x, double half_z) {
  for (const double x : {-half_x, half_x}) {
    for (const double z : {-half_z, half_z}) {
      add(mesh, finish, plank(leg, 0.006), at(x, leg.y() / 2, z));
    }
  }
}

/// Adds a drawer's front with its knob, in the plane z = 0 around the origin.
void add_drawer_front(Mesh& mesh, Finish finish, double width, double height) {
  add(mesh, finish, plank({width, height, 0.018}, 0.004));
  add(mesh, Finish::brass, sphere(0.014, 12), at(0, 0, 0.022));
}

}  // namespace

Mesh dining_table() {
  Mesh mesh = {"dining_table", {}};
  for (int board = 0; board < 5; ++board) {
    add(mesh, Finish::oak, plank({1.4, 0.034, 0.158 - 0.0004 * board}, 0.004),
        at(0, 0.733, 0.16 * (board - 2)));
  }
  add_legs(mesh, Finish::oak, {0.07, 0.714, 0.07}, 0.62, 0.32);
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::oak, plank({1.16, 0.09, 0.024}), at(0, 0.665, side * 0.32));
    add(mesh, Finish::oak, plank({0.024, 0.09, 0.56}), at(side * 0.62, 0.665, 0));
  }
  return mesh;
}

Mesh coffee_table() {
  Mesh mesh = {"coffee_table", {}};
  add(mesh, Finish::marble, box({1.0, 0.03, 0.6}, 0.008), at(0, 0.405, 0));
  add(mesh, Finish::walnut, plank({0.9, 0.05, 0.5}), at(0, 0.363, 0));
  add_legs(mesh, Finish::walnut, {0.05, 0.36, 0.05}, 0.42, 0.22);
  add(mesh, Finish::walnut, plank({0.86, 0.018, 0.46}), at(0, 0.14, 0));
  return mesh;
}

Mesh side_table() {
  Mesh mesh = {"side_table", {}};
  add(mesh, Finish::tiles, box({0.4, 0.012, 0.4}, 0.002), at(0, 0.493, 0));
  add(mesh, Finish::walnut, plank({0.43, 0.03, 0.43}, 0.006), at(0, 0.471, 0));
  add_legs(mesh, Finish::walnut, {0.034, 0.455, 0.034}, 0.19, 0.19);
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::walnut, plank({0.346, 0.03, 0.018}), at(0, 0.16, side * 0.19));
    add(mesh, Finish::walnut, plank({0.018, 0.03, 0.346}), at(side * 0.19, 0.16, 0));
  }
  return mesh;
}

Mesh desk() {
  Mesh mesh = {"desk", {}};
  add(mesh, Finish::walnut, plank({1.3, 0.03, 0.65}, 0.004), at(0, 0.735, 0));
  add(mesh, Finish::walnut, plank({0.028, 0.719, 0.6}), at(-0.61, 0.36, 0));
  add(mesh, Finish::walnut, plank({0.4, 0.67, 0.58}), at(0.42, 0.384, -0.01));
  add(mesh, Finish::black_plastic, box({0.38, 0.046, 0.55}), at(0.42, 0.0235, -0.02));
  for (int drawer = 0; drawer < 3; ++drawer) {
    Mesh front;
    add_drawer_front(front, Finish::walnut, 0.384, 0.205);
    for (const MeshPart& part : front.parts) {
      add(mesh, part.finish, part.shape, at(0.42, 0.168 + 0.217 * drawer, 0.2905));
    }
  }
  add(mesh, Finish::walnut, plank({0.79, 0.3, 0.018}), at(-0.19, 0.55, -0.27));
  return mesh;
}

}  // namespace scenes
