#include "tools/make_scenes/furniture/clutter.h"

#include <cmath>
#include <numbers>

#include "tools/make_scenes/painting/noise.h"

namespace scenes {
namespace {

using Eigen::Vector3d;

Color pastel(std::uint32_t seed, int i) {
  return {0.15 + 0.6 * random01(seed, i, 0), 0.12 + 0.45 * random01(seed, i, 1),
          0.1 + 0.45 * random01(seed, i, 2)};
}

Shape cup_handle() {
  const auto ring = [](double u, double v) {
    const double around = 2 * std::numbers::pi * v;
    const double along = std::numbers::pi * (0.5 - u);
    const double radius = 0.026 + 0.005 * std::cos(around);
    return Vector3d(0.038 + radius * std::cos(along), 0.048 + radius * std::sin(along),
                    0.005 * std::sin(-around));
  };
  return sheet(ring, {10, 6, {1, 1}});
}

}  // namespace

Mesh fruit_bowl() {
  Mesh mesh = {"fruit_bowl", {}};
  add(mesh, Finish::porcelain,
      lathe({{0, 0.001},
             {0.06, 0.001},
             {0.06, 0.001},
             {0.065, 0.012},
             {0.12, 0.045},
             {0.15, 0.09},
             {0.155, 0.095},
             {0.15, 0.097},
             {0.143, 0.09},
             {0.112, 0.05},
             {0.05, 0.02},
             {0, 0.018}},
            36));
  for (int i = 0; i < 6; ++i) {
    const bool top = i == 5;
    const double angle = 72 * i;
    const Color peel = i % 3 == 0 ? Color(0.35, 0.5, 0.08) : Color(0.85, 0.36 + 0.03 * i, 0.04);
    add(mesh, Finish::paint, painted(sphere(0.041, 18), peel),
        top ? at(0, 0.125, 0) : about_y(angle) * at(0, 0.075, 0.073));
  }
  return mesh;
}

Mesh cup(const Color& color) {
  Mesh mesh = {"cup", {}};
  add(mesh, Finish::paint,
      painted(lathe({{0, 0.001},
                     {0.034, 0.001},
                     {0.038, 0.006},
                     {0.04, 0.05},
                     {0.04, 0.095},
                     {0.0385, 0.097},
                     {0.037, 0.095},
                     {0.037, 0.02},
                     {0.034, 0.015},
                     {0, 0.015}},
                    24),
              color));
  add(mesh, Finish::paint, painted(cup_handle(), color));
  add(mesh, Finish::soil, lathe({{0.037, 0.08}, {0, 0.08}}, 20));
  return mesh;
}

Mesh bottle() {
  Mesh mesh = {"bottle", {}};
  add(mesh, Finish::paint,
      painted(lathe({{0, 0.001},
                     {0.037, 0.001},
                     {0.037, 0.001},
                     {0.037, 0.18},
                     {0.03, 0.215},
                     {0.014, 0.24},
                     {0.013, 0.29},
                     {0.015, 0.295},
                     {0.015, 0.3},
                     {0, 0.3}},
                    20),
              {0.05, 0.16, 0.08}));
  const Shape label = lathe({{0.038, 0.05}, {0.038, 0.14}}, 20);
  add(mesh, Finish::paper, label);
  return mesh;
}

Mesh plate() {
  Mesh mesh = {"plate", {}};
  add(mesh, Finish::porcelain,
      lathe({{0, 0.001},
             {0.08, 0.001},
             {0.085, 0.006},
             {0.13, 0.016},
             {0.131, 0.019},
             {0.125, 0.019},
             {0.085, 0.009},
             {0, 0.007}},
            32));
  return mesh;
}

Mesh packet(const Vector3d& size, const Color& color) {
  Mesh mesh = {"packet", {}};
  add(mesh, Finish::paint, painted(box(size, 0.002), color), at(0, size.y() / 2 + 0.001, 0));
  const Shape print =
      painted(panel(size.x() * 0.92, size.y() * 0.94), color * 0.6 + Color(0.4, 0.4, 0.4));
  for (const double turn : {0.0, 180.0}) {
    add(mesh, Finish::print, print,
        about_y(turn) * at(0, size.y() / 2 + 0.001, size.z() / 2 + 0.001));
  }
  return mesh;
}

Mesh building_blocks() {
  Mesh mesh = {"building_blocks", {}};
  for (int i = 0; i < 14; ++i) {
    const bool upper = i >= 10;
    const double reach = upper ? 0.07 : 0.07 + 0.2 * random01(211, i, 3);
    const double angle = 36 * i + 30 * random01(211, i, 4);
    const double y = upper ? 0.0765 + 0.051 * (i - 10) : 0.0255;
    const Eigen::Isometry3d place =
        upper ? at(0.004 * (i % 3), y, 0.003 * (i % 2)) : about_y(angle) * at(0, y, reach + 0.03);
    const Vector3d size(0.05, 0.05, upper || i % 3 != 0 ? 0.05 : 0.1);
    add(mesh, Finish::paint, painted(box(size, 0.003), pastel(212, i)),
        place * about_y(70 * random01(211, i, 5)));
  }
  add(mesh, Finish::paint, painted(box({0.05, 0.05, 0.05}, 0.003), {0.6, 0.12, 0.1}),
      at(0, 0.0255, 0));
  return mesh;
}

Mesh monitor() {
  Mesh mesh = {"monitor", {}};
  const Eigen::Isometry3d head = at(0, 0.33, 0.02) * about_x(-4);
  add(mesh, Finish::black_plastic, box({0.62, 0.37, 0.03}, 0.006), head);
  add(mesh, Finish::screen, panel(0.596, 0.346), head * at(0, 0, 0.0165));
  add(mesh, Finish::steel, box({0.06, 0.26, 0.014}, 0.004), at(0, 0.15, -0.02));
  add(mesh, Finish::steel, soft_box({0.24, 0.014, 0.18}, 0.006, 2), at(0, 0.009, 0));
  return mesh;
}

Mesh laptop() {
  Mesh mesh = {"laptop", {}};
  add(mesh, Finish::steel, box({0.33, 0.014, 0.23}, 0.004), at(0, 0.009, 0));
  const Eigen::Isometry3d lid = at(0, 0.018, -0.115) * about_x(-22) * at(0, 0.112, 0);
  add(mesh, Finish::steel, box({0.33, 0.22, 0.008}, 0.003), lid);
  add(mesh, Finish::screen, panel(0.31, 0.195), lid * at(0, 0.004, 0.0055));
  for (int row = 0; row < 5; ++row) {
    for (int key = 0; key < 12; ++key) {
      add(mesh, Finish::black_plastic, box({0.021, 0.003, 0.017}),
          at(0.0255 * (key - 5.5), 0.0185, -0.075 + 0.021 * row));
    }
  }
  return mesh;
}

Mesh keyboard() {
  Mesh mesh = {"keyboard", {}};
  add(mesh, Finish::porcelain, box({0.42, 0.016, 0.135}, 0.005), at(0, 0.01, 0));
  for (int row = 0; row < 5; ++row) {
    for (int key = 0; key < 15; ++key) {
      const Color shade = Color::Constant(key == 0 || key == 14 ? 0.25 : 0.5);
      add(mesh, Finish::paint, painted(box({0.022, 0.008, 0.02}), shade),
          at(0.0265 * (key - 7), 0.024, 0.025 * (row - 2)));
    }
  }
  return mesh;
}

}  // namespace scenes
