#include "tools/make_scenes/furniture/architecture.h"

#include <cmath>
#include <numbers>

#include "tools/make_scenes/painting/noise.h"

namespace scenes {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Adds the four faces of an opening, from the wall's plane to `depth` m behind it.
void add_reveal(Mesh& mesh, const Opening& opening, double depth, Finish finish) {
  const Vector3d back(0, 0, -depth);
  const Vector3d along(opening.right - opening.left, 0, 0);
  const Vector3d up(0, opening.top - opening.bottom, 0);
  const Vector3d corner(opening.left, opening.bottom, 0);
  add(mesh, finish, rectangle(corner + back, along, -back));
  add(mesh, finish, rectangle(corner + up, along, back));
  add(mesh, finish, rectangle(corner + up, back, -up));
  add(mesh, finish, rectangle(corner + up + along + back, -back, -up));
}

/// Adds leaves on a ball around the origin, which hide most of what is behind.
void add_crown(Mesh& mesh, double radius, const Eigen::Isometry3d& T_mesh_crown) {
  constexpr int kLeaves = 260;
  const double golden = 180 * (3 - std::sqrt(5.0));
  for (int i = 0; i < kLeaves; ++i) {
    const double height = 1 - 2 * (i + 0.5) / kLeaves;
    const double tilt = std::acos(height) * 180 / std::numbers::pi;
    const double out = radius * (0.6 + 0.4 * random01(901, i, 0));
    const double size = 0.24 * radius * (0.8 + 0.6 * random01(901, i, 1));
    add(mesh, Finish::leaf, panel(size, 1.6 * size),
        T_mesh_crown * about_y(golden * i) * about_x(tilt - 90) * at(0, 0, out) *
            about_z(360 * random01(901, i, 2)) * about_x(60 * random01(901, i, 3) - 30));
  }
}

}  // namespace

Mesh pierced_wall(const Vector2d& size, const std::vector<Opening>& openings, double depth,
                  Finish finish) {
  Mesh mesh = {"pierced_wall", {}};
  const auto piece = [&](double left, double right, double bottom, double top) {
    if (right > left && top > bottom) {
      add(mesh, finish,
          rectangle({left, top, 0}, {right - left, 0, 0}, {0, bottom - top, 0}, {left, -top}));
    }
  };
  double done = -size.x() / 2;
  for (const Opening& opening : openings) {
    piece(done, opening.left, 0, size.y());
    piece(opening.left, opening.right, 0, opening.bottom);
    piece(opening.left, opening.right, opening.top, size.y());
    add_reveal(mesh, opening, depth, finish);
    done = opening.right;
  }
  piece(done, size.x() / 2, 0, size.y());
  return mesh;
}

Mesh tall_window(double width, double height) {
  constexpr double kBar = 0.06;
  Mesh mesh = {"tall_window", {}};
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::white_paint, box({kBar, height, 0.07}, 0.005),
        at(side * (width - kBar) / 2, height / 2, 0));
    add(mesh, Finish::white_paint, box({width - 2 * kBar, kBar, 0.066}, 0.005),
        at(0, height / 2 + side * (height - kBar) / 2, 0));
  }
  add(mesh, Finish::white_paint, box({0.04, height - 2 * kBar, 0.05}, 0.005), at(0, height / 2, 0));
  for (const double part : {0.25, 0.5, 0.75}) {
    add(mesh, Finish::white_paint, box({width - 2 * kBar, 0.03, 0.046}, 0.004),
        at(0, part * height, 0));
  }
  add(mesh, Finish::window_glass, panel(width - 2 * kBar, height - 2 * kBar),
      at(0, height / 2, 0.001));
  return mesh;
}

Mesh column(double height) {
  Mesh mesh = {"column", {}};
  add(mesh, Finish::marble, box({0.44, 0.12, 0.44}, 0.01), at(0, 0.06, 0));
  add(mesh, Finish::marble,
      lathe({{0.2, 0.12},
             {0.21, 0.16},
             {0.18, 0.2},
             {0.165, 0.24},
             {0.16, height / 3},
             {0.14, height - 0.3},
             {0.14, height - 0.3},
             {0.17, height - 0.27},
             {0.15, height - 0.24},
             {0.21, height - 0.12}},
            36));
  add(mesh, Finish::marble, box({0.44, 0.12, 0.44}, 0.01), at(0, height - 0.06, 0));
  return mesh;
}

Mesh bench() {
  Mesh mesh = {"bench", {}};
  for (const double z : {-0.15, 0.0, 0.15}) {
    add(mesh, Finish::oak, plank({1.5, 0.03, 0.13}, 0.006), at(0, 0.435, z));
  }
  for (const double x : {-0.6, 0.6}) {
    add(mesh, Finish::steel, box({0.05, 0.42, 0.38}, 0.008), at(x, 0.21, 0));
  }
  return mesh;
}

Mesh fountain() {
  Mesh mesh = {"fountain", {}};
  add(mesh, Finish::marble,
      lathe({{1.1, 0},
             {1.1, 0.4},
             {1.1, 0.4},
             {1.12, 0.46},
             {0.96, 0.46},
             {0.96, 0.46},
             {0.94, 0.1},
             {0.94, 0.1},
             {0, 0.1}},
            64));
  add(mesh, Finish::marble,
      lathe({{0.2, 0.1},
             {0.12, 0.25},
             {0.1, 0.8},
             {0.16, 0.92},
             {0.5, 1.08},
             {0.52, 1.12},
             {0.44, 1.11},
             {0.1, 1.0},
             {0.06, 1.4},
             {0.08, 1.46},
             {0, 1.5}},
            48));
  add(mesh, Finish::window_glass, lathe({{0.945, 0.36}, {0, 0.36}}, 48));
  return mesh;
}

Mesh tree(double height) {
  Mesh mesh = {"tree", {}};
  const double radius = 0.3 * height;
  add(mesh, Finish::walnut,
      lathe({{0.12, 0}, {0.075, 0.2}, {0.06, height - radius}, {0.02, height - 0.4 * radius}}, 16));
  for (int i = 0; i < 5; ++i) {
    add(mesh, Finish::walnut, lathe({{0.03, 0}, {0.008, 0.9 * radius}}, 8),
        at(0, height - 1.4 * radius, 0) * about_y(72 * i) * about_x(38));
  }
  add_crown(mesh, radius, at(0, height - radius, 0));
  add_crown(mesh, 0.55 * radius, at(0, height - radius, 0));
  return mesh;
}

Mesh planter() {
  Mesh mesh = {"planter", {}};
  add(mesh, Finish::pine, plank({0.9, 0.4, 0.4}, 0.006), at(0, 0.2, 0));
  add(mesh, Finish::soil, box({0.84, 0.02, 0.34}), at(0, 0.4, 0));
  for (int i = 0; i < 3; ++i) {
    add_crown(mesh, 0.2, at(0.27 * (i - 1), 0.55 + 0.03 * (i % 2), 0) * about_y(50 * i));
  }
  return mesh;
}

Mesh chandelier() {
  Mesh mesh = {"chandelier", {}};
  add(mesh, Finish::black_plastic, cylinder(0.006, kChandelierDrop, 8), at(0, -kChandelierDrop, 0));
  add(mesh, Finish::brass, lathe({{0.03, -1.62}, {0.05, -1.5}, {0.02, -1.3}, {0.01, -1.2}}, 20));
  for (int i = 0; i < 8; ++i) {
    const Eigen::Isometry3d arm = about_y(45 * i);
    add(mesh, Finish::brass, cylinder(0.009, 0.52, 10), arm * at(0.03, -1.52, 0) * about_z(-84));
    add(mesh, Finish::brass, lathe({{0, -0.01}, {0.03, 0}, {0.035, 0.02}}, 14),
        arm * at(0.55, -1.47, 0));
    add(mesh, Finish::lamp_glow, lathe({{0.012, 0.02}, {0.018, 0.05}, {0, 0.1}}, 12),
        arm * at(0.55, -1.47, 0));
  }
  return mesh;
}

Mesh flight_of_stairs(const Flight& flight) {
  Mesh mesh = {"flight", {}};
  for (int i = 0; i < flight.steps; ++i) {
    const double top = flight.rise * (i + 1);
    const double z = -flight.going * i;
    add(mesh, Finish::oak, plank({flight.width, 0.03, flight.going + 0.03}, 0.006),
        at(0, top - 0.015, z - flight.going / 2 + 0.015));
    add(mesh, Finish::white_paint, box({flight.width - 0.02, flight.rise - 0.03, 0.02}),
        at(0, top - 0.03 - (flight.rise - 0.03) / 2, z - 0.01));
  }
  return mesh;
}

Mesh banister(const Flight& flight) {
  constexpr double kHigh = 0.95;  // m, of the rail above the steps
  Mesh mesh = {"banister", {}};
  const double length = std::hypot(flight.rise, flight.going) * (flight.steps - 1);
  const double slope = std::atan2(flight.rise, flight.going) * 180 / std::numbers::pi;
  for (int i = 0; i < flight.steps; i += 2) {
    add(mesh, Finish::steel, cylinder(0.012, kHigh, 12),
        at(0, flight.rise * (i + 1), -flight.going * (i + 0.5)));
  }
  add(mesh, Finish::oak, plank({0.06, 0.05, length + 0.3}, 0.015),
      at(0, flight.rise * (1 + (flight.steps - 1) / 2.0) + kHigh,
         -flight.going * flight.steps / 2) *
          about_x(slope));
  return mesh;
}

}  // namespace scenes
