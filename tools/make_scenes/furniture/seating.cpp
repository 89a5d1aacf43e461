#include "tools/make_scenes/furniture/seating.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace scenes {
namespace {

constexpr double kSeatHeight = 0.45;  // m

void add_chair_back(Mesh& mesh) {
  const Eigen::Isometry3d back = at(0, kSeatHeight, -0.2) * about_x(-8);
  for (const double x : {-0.2, 0.2}) {
    add(mesh, Finish::pine, plank({0.034, 0.44, 0.028}, 0.006), back * at(x, 0.21, 0));
  }
  for (const double y : {0.2, 0.3}) {
    add(mesh, Finish::pine, plank({0.37, 0.045, 0.016}, 0.004), back * at(0, y, 0));
  }
  add(mesh, Finish::pine, plank({0.43, 0.075, 0.024}, 0.008), back * at(0, 0.405, 0.001));
}

void add_sofa_cushions(Mesh& mesh, double width) {
  for (const double side : {-1.0, 1.0}) {
    const double x = side * width / 4;
    add(mesh, Finish::sofa_fabric, soft_box({width / 2 - 0.012, 0.17, 0.66}, 0.05),
        at(x, 0.375, 0.1));
    add(mesh, Finish::sofa_fabric, soft_box({width / 2 - 0.015, 0.42, 0.17}, 0.06),
        at(x, 0.66, -0.235) * about_x(-12));
  }
}

}  // namespace

Mesh chair() {
  Mesh mesh = {"chair", {}};
  add(mesh, Finish::pine, plank({0.44, 0.03, 0.42}, 0.008), at(0, kSeatHeight - 0.015, 0));
  add(mesh, Finish::rust_fabric, soft_box({0.39, 0.045, 0.37}, 0.018), at(0, 0.474, 0.005));
  for (const double x : {-0.185, 0.185}) {
    for (const double z : {-0.175, 0.175}) {
      add(mesh, Finish::pine, plank({0.036, 0.418, 0.036}, 0.006), at(x, 0.21, z));
    }
    add(mesh, Finish::pine, plank({0.02, 0.03, 0.31}, 0.004), at(x, 0.2, 0));
  }
  for (const double z : {-0.175, 0.175}) {
    add(mesh, Finish::pine, plank({0.33, 0.05, 0.018}, 0.004), at(0, 0.39, z));
  }
  add_chair_back(mesh);
  return mesh;
}

Mesh sofa() {
  constexpr double kWidth = 1.55;  // m between the arms
  Mesh mesh = {"sofa", {}};
  add(mesh, Finish::sofa_fabric, soft_box({kWidth, 0.18, 0.82}, 0.03), at(0, 0.2, 0));
  add(mesh, Finish::sofa_fabric, soft_box({kWidth + 0.02, 0.55, 0.14}, 0.05), at(0, 0.5, -0.36));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::sofa_fabric, soft_box({0.17, 0.48, 0.86}, 0.06),
        at(side * (kWidth / 2 + 0.086), 0.35, 0));
    for (const double z : {-0.34, 0.34}) {
      add(mesh, Finish::walnut, cylinder(0.022, 0.115, 10), at(side * 0.78, 0, z));
    }
  }
  add_sofa_cushions(mesh, kWidth);
  return mesh;
}

Mesh cushion(Finish fabric) {
  constexpr double kHalf = 0.21;  // m
  Mesh mesh = {"cushion_" + std::to_string(static_cast<int>(fabric)), {}};
  for (const double side : {1.0, -1.0}) {
    const auto bulge = [side](double u, double v) {
      const double x = 2 * u - 1;
      const double y = 1 - 2 * v;
      const double edge = (1 - x * x) * (1 - y * y);
      const double pinch = 1 - 0.07 * (1 - x * x) * y * y - 0.07 * (1 - y * y) * x * x;
      return Eigen::Vector3d(side * kHalf * x * pinch, kHalf * y * pinch,
                             side * 0.075 * std::sqrt(std::max(edge, 0.0) + 1e-4));
    };
    add(mesh, fabric, sheet(bulge, {10, 10, {0.42, 0.42}}));
  }
  return mesh;
}

}  // namespace scenes
