#include "tools/make_scenes/furniture/storage.h"

namespace scenes {
namespace {

void add_cupboard_door(Mesh& mesh, const Eigen::Isometry3d& T_mesh_door, double knob_x) {
  add(mesh, Finish::oak, plank({0.476, 0.6, 0.018}, 0.004), T_mesh_door);
  add(mesh, Finish::white_paint, box({0.37, 0.49, 0.008}, 0.003), T_mesh_door * at(0, 0, 0.0135));
  add(mesh, Finish::brass, sphere(0.016, 12), T_mesh_door * at(knob_x, 0.06, 0.024));
}

}  // namespace

Mesh bookcase() {
  Mesh mesh = {"bookcase", {}};
  for (const double x : {-0.788, 0.0, 0.788}) {
    add(mesh, Finish::pine, plank({0.024, 2.05, 0.32}), at(x, 1.025, 0));
  }
  for (const double side : {-1.0, 1.0}) {
    const double x = side * 0.394;
    for (const double top : kShelfHeights) {
      add(mesh, Finish::pine, plank({0.762, 0.022, 0.3}), at(x, top - 0.011, 0.004));
    }
    add(mesh, Finish::pine, plank({0.762, 0.024, 0.31}), at(x, 2.036, 0));
    add(mesh, Finish::pine, plank({0.762, 0.076, 0.018}), at(x, 0.04, 0.13));
    add(mesh, Finish::cardboard, box({0.762, 1.93, 0.006}), at(x, 1.05, -0.154));
  }
  return mesh;
}

Mesh sideboard() {
  Mesh mesh = {"sideboard", {}};
  add(mesh, Finish::oak, plank({1.5, 0.03, 0.42}, 0.006), at(0, 0.785, 0));
  add(mesh, Finish::oak, plank({1.46, 0.65, 0.37}, 0.004), at(0, 0.444, -0.015));
  for (const double x : {-0.68, 0.68}) {
    for (const double z : {-0.15, 0.14}) {
      add(mesh, Finish::oak, plank({0.045, 0.118, 0.045}, 0.006), at(x, 0.0595, z));
    }
  }
  add_cupboard_door(mesh, at(-0.484, 0.444, 0.1805), 0.2);
  add_cupboard_door(mesh, at(0, 0.444, 0.1805), 0.2);
  add_cupboard_door(mesh, at(0.484, 0.444, 0.1805), -0.2);
  return mesh;
}

Mesh wall_shelf() {
  Mesh mesh = {"wall_shelf", {}};
  add(mesh, Finish::walnut, plank({1.1, 0.03, 0.22}, 0.005), at(0, -0.015, 0.111));
  for (const double x : {-0.4, 0.4}) {
    add(mesh, Finish::brass, box({0.02, 0.16, 0.012}, 0.003), at(x, -0.112, 0.008));
    add(mesh, Finish::brass, box({0.016, 0.012, 0.2}, 0.003), at(x, -0.0375, 0.115));
    add(mesh, Finish::brass, box({0.012, 0.012, 0.2}, 0.003), at(x, -0.105, 0.085) * about_x(-40));
  }
  return mesh;
}

Mesh parcel(const Eigen::Vector3d& size) {
  Mesh mesh = {"parcel", {}};
  add(mesh, Finish::cardboard, box(size, 0.004), at(0, size.y() / 2, 0));
  const Shape tape = painted(box({size.x() + 0.003, 0.002, 0.05}), {0.55, 0.45, 0.28});
  add(mesh, Finish::paint, tape, at(0, size.y() + 0.0015, 0));
  add(mesh, Finish::print, panel(0.14, 0.2),
      at(size.x() / 5, size.y() * 0.55, size.z() / 2 + 0.001));
  return mesh;
}

Mesh basket() {
  Mesh mesh = {"basket", {}};
  add(mesh, Finish::carpet,
      lathe({{0, 0.004},
             {0.13, 0.004},
             {0.13, 0.004},
             {0.15, 0.15},
             {0.165, 0.3},
             {0.165, 0.3},
             {0.15, 0.3},
             {0.15, 0.3},
             {0.137, 0.15},
             {0.118, 0.02},
             {0.118, 0.02},
             {0, 0.02}},
            28));
  return mesh;
}

}  // namespace scenes
