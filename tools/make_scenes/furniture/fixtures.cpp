#include "tools/make_scenes/furniture/fixtures.h"

#include <cmath>
#include <numbers>

namespace scenes {
namespace {

using Eigen::Vector3d;

constexpr double kWallThickness = 0.22;  // m

/// Adds the wall with the window in pieces whose texture is continuous.
void add_window_wall(Mesh& mesh) {
  const auto piece = [&](double z_left, double z_right, double bottom, double top) {
    add(mesh, Finish::plain_wall,
        rectangle({kHalfWidth, top, z_left}, {0, 0, z_right - z_left}, {0, bottom - top, 0},
                  {z_left, -top}));
  };
  const double left = kWindowZ - kWindowWidth / 2;
  const double right = kWindowZ + kWindowWidth / 2;
  const double top = kWindowSill + kWindowHeight;
  piece(-kHalfDepth, left, 0, kHeight);
  piece(right, kHalfDepth, 0, kHeight);
  piece(left, right, 0, kWindowSill);
  piece(left, right, top, kHeight);
  const Vector3d out(kWallThickness, 0, 0);
  const Vector3d along(0, 0, kWindowWidth);
  const Vector3d up(0, kWindowHeight, 0);
  const Vector3d corner(kHalfWidth, kWindowSill, left);
  add(mesh, Finish::plain_wall, rectangle(corner + up, along, out));
  add(mesh, Finish::plain_wall, rectangle(corner + out, along, -out));
  add(mesh, Finish::plain_wall, rectangle(corner + up, out, -up));
  add(mesh, Finish::plain_wall, rectangle(corner + up + along + out, -out, -up));
}

void add_door_panel(Mesh& mesh, double y, double height) {
  add(mesh, Finish::white_paint, box({0.62, height, 0.024}, 0.01), at(0, y, 0.039));
  add(mesh, Finish::white_paint, box({0.5, height - 0.12, 0.024}, 0.01), at(0, y, 0.05));
}

}  // namespace

Mesh plain_shell(const Vector3d& size, const ShellFinishes& finishes) {
  Mesh mesh = {"shell", {}};
  const Vector3d x(size.x(), 0, 0);
  const Vector3d y(0, size.y(), 0);
  const Vector3d z(0, 0, size.z());
  const Vector3d corner(-size.x() / 2, 0, -size.z() / 2);
  add(mesh, finishes.floor, rectangle(corner, x, z));
  add(mesh, finishes.ceiling, rectangle(corner + y + z, x, -z));
  if (finishes.north) {
    add(mesh, *finishes.north, rectangle(corner + y, x, -y));
  }
  add(mesh, finishes.east, rectangle(corner + x + y, z, -y));
  add(mesh, finishes.south, rectangle(corner + x + y + z, -x, -y));
  add(mesh, finishes.west, rectangle(corner + y + z, -z, -y));
  return mesh;
}

Mesh shell() {
  Mesh mesh = {"shell", {}};
  const Vector3d x(2 * kHalfWidth, 0, 0);
  const Vector3d y(0, kHeight, 0);
  const Vector3d z(0, 0, 2 * kHalfDepth);
  const Vector3d corner(-kHalfWidth, 0, -kHalfDepth);
  add(mesh, Finish::floor, rectangle(corner, x, z));
  add(mesh, Finish::ceiling, rectangle(corner + y + z, x, -z));
  add(mesh, Finish::brick, rectangle(corner + y, x, -y));
  add(mesh, Finish::plain_wall, rectangle(corner + x + y + z, -x, -y));
  add(mesh, Finish::wallpaper, rectangle(corner + y + z, -z, -y));
  add_window_wall(mesh);
  for (const double beam_x : {-2.1, -0.85, 0.75, 2.0}) {
    add(mesh, Finish::walnut, plank({0.13, 0.16, 2 * kHalfDepth + 0.04}, 0.008),
        at(beam_x, kHeight - 0.05, 0));
  }
  return mesh;
}

Mesh window() {
  Mesh mesh = {"window", {}};
  constexpr double kPlane = -0.12;  // position of the frame behind the wall's face, m
  const double middle = kWindowHeight / 2;
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::white_paint, box({0.055, kWindowHeight + 0.02, 0.06}, 0.006),
        at(side * (kWindowWidth / 2 - 0.0225), middle, kPlane));
    add(mesh, Finish::white_paint, box({kWindowWidth - 0.092, 0.055, 0.058}, 0.006),
        at(0, middle + side * (middle - 0.0225), kPlane));
  }
  add(mesh, Finish::white_paint, box({0.08, kWindowHeight - 0.092, 0.05}, 0.006),
      at(0, middle, kPlane + 0.002));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::white_paint, box({0.66, 0.026, 0.034}, 0.005),
        at(side * 0.375, kWindowHeight * 0.66, kPlane));
  }
  add(mesh, Finish::brass, box({0.016, 0.11, 0.02}, 0.005), at(0, 0.55, kPlane + 0.04));
  add(mesh, Finish::marble, box({kWindowWidth + 0.12, 0.03, 0.26}, 0.006), at(0, 0.016, 0.04));
  return mesh;
}

Mesh curtain() {
  constexpr double kWidth = 0.5;
  constexpr double kDrop = 2.3;
  Mesh mesh = {"curtain", {}};
  const auto folds = [](double u, double v) {
    const double depth = 0.025 + 0.02 * v;
    const double phase = 2 * std::numbers::pi * (6 * u + 0.12 * std::sin(5 * v));
    return Vector3d(kWidth * (u - 0.5) * (1 + 0.06 * v), -kDrop * v, depth * std::sin(phase));
  };
  add(mesh, Finish::linen, sheet(folds, {60, 8, {0.9, kDrop}}));
  return mesh;
}

Mesh curtain_rod() {
  Mesh mesh = {"curtain_rod", {}};
  add(mesh, Finish::brass, cylinder(0.012, 2.9, 12), at(-1.45, 0, 0) * about_z(-90));
  for (const double x : {-1.45, 1.45}) {
    add(mesh, Finish::brass, sphere(0.026, 14), at(x, 0, 0));
  }
  for (const double x : {-1.15, 1.15}) {
    add(mesh, Finish::brass, cylinder(0.008, 0.1, 10), at(x, 0, -0.1) * about_x(90));
  }
  return mesh;
}

Mesh view() {
  Mesh mesh = {"view", {}};
  add(mesh, Finish::view, panel(24, 8));
  return mesh;
}

Mesh door() {
  Mesh mesh = {"door", {}};
  add(mesh, Finish::white_paint, box({0.86, 2.03, 0.04}, 0.004), at(0, 1.02, 0.016));
  add_door_panel(mesh, 1.43, 1.0);
  add_door_panel(mesh, 0.47, 0.68);
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::white_paint, box({0.09, 2.13, 0.05}, 0.008), at(side * 0.478, 1.061, 0.02));
  }
  add(mesh, Finish::white_paint, box({0.864, 0.09, 0.05}, 0.008), at(0, 2.085, 0.019));
  add(mesh, Finish::brass, box({0.04, 0.2, 0.008}, 0.003), at(-0.375, 1.02, 0.04));
  add(mesh, Finish::brass, cylinder(0.009, 0.05, 12), at(-0.375, 1.06, 0.05) * about_x(90));
  add(mesh, Finish::brass, cylinder(0.009, 0.12, 12), at(-0.38, 1.06, 0.1) * about_z(-90));
  return mesh;
}

Mesh radiator() {
  Mesh mesh = {"radiator", {}};
  constexpr int kColumns = 20;
  for (int i = 0; i < kColumns; ++i) {
    const double x = 0.06 * (i - (kColumns - 1) / 2.0);
    add(mesh, Finish::white_paint, box({0.042, 0.6, 0.09}, 0.014), at(x, 0.3, 0.085));
  }
  for (const double y : {0.07, 0.53}) {
    add(mesh, Finish::white_paint, cylinder(0.022, 1.3, 12), at(-0.65, y, 0.085) * about_z(-90));
  }
  add(mesh, Finish::steel, cylinder(0.01, 0.22, 10), at(0.645, -0.15, 0.085));
  add(mesh, Finish::porcelain, cylinder(0.022, 0.07, 16), at(0.655, 0.07, 0.085) * about_z(-90));
  return mesh;
}

Mesh skirting(double length) {
  Mesh mesh = {"skirting", {}};
  add(mesh, Finish::white_paint, box({length, 0.09, 0.016}, 0.004), at(0, 0.041, 0.005));
  return mesh;
}

Mesh light_switch() {
  Mesh mesh = {"light_switch", {}};
  add(mesh, Finish::porcelain, box({0.085, 0.085, 0.012}, 0.004), at(0, 0, 0.007));
  add(mesh, Finish::porcelain, box({0.045, 0.06, 0.012}, 0.003), at(0, 0, 0.014) * about_x(4));
  return mesh;
}

}  // namespace scenes
