#include "tools/make_scenes/furniture/kitchen_things.h"

#include <numbers>

namespace scenes {
namespace {

using Eigen::Vector3d;

constexpr double kCounterLength = 3.0;  // m
constexpr double kCounterDepth = 0.62;  // m
constexpr double kSlab = 0.04;          // m, thickness of the worktop
constexpr double kSinkX = -0.85;        // m, centre of the sink
constexpr double kHobX = 0.6;           // m, centre of hob and oven
const Eigen::Vector2d kSink(0.5, 0.4);  // m

/// Adds an upright handle of `length` m around the origin.
void add_handle(Mesh& mesh, double length, const Eigen::Isometry3d& T_mesh_handle) {
  add(mesh, Finish::polished_steel, cylinder(0.007, length, 12),
      T_mesh_handle * at(0, -length / 2, 0.035));
  for (const double y : {-0.4 * length, 0.4 * length}) {
    add(mesh, Finish::polished_steel, cylinder(0.005, 0.035, 10),
        T_mesh_handle * at(0, y, 0) * about_x(90));
  }
}

/// Adds the worktop in four slabs around the sink's opening.
void add_worktop(Mesh& mesh) {
  const double y = kCounterTop - kSlab / 2;
  const double left = kSinkX - kSink.x() / 2;
  const double right = kSinkX + kSink.x() / 2;
  const double half = kCounterLength / 2;
  const double strip = (kCounterDepth - kSink.y()) / 2;
  add(mesh, Finish::marble, box({left + half, kSlab, kCounterDepth}), at((left - half) / 2, y, 0));
  add(mesh, Finish::marble, box({half - right, kSlab, kCounterDepth}),
      at((right + half) / 2, y, 0));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::marble, box({kSink.x(), kSlab, strip}),
        at(kSinkX, y, side * (kSink.y() + strip) / 2));
  }
}

void add_sink(Mesh& mesh) {
  constexpr double kDeep = 0.18;
  const Vector3d x(kSink.x(), 0, 0);
  const Vector3d down(0, -kDeep, 0);
  const Vector3d z(0, 0, kSink.y());
  const Vector3d corner(kSinkX - kSink.x() / 2, kCounterTop - 0.002, -kSink.y() / 2);
  add(mesh, Finish::brushed_steel, rectangle(corner + down, x, z));
  add(mesh, Finish::brushed_steel, rectangle(corner, x, down));
  add(mesh, Finish::brushed_steel, rectangle(corner + x, z, down));
  add(mesh, Finish::brushed_steel, rectangle(corner + x + z, -x, down));
  add(mesh, Finish::brushed_steel, rectangle(corner + z, -z, down));
  const Eigen::Isometry3d tap = at(kSinkX, kCounterTop, -kSink.y() / 2 - 0.05);
  add(mesh, Finish::polished_steel, cylinder(0.016, 0.28, 20), tap);
  add(mesh, Finish::polished_steel, cylinder(0.012, 0.2, 16), tap * at(0, 0.27, 0) * about_x(90));
  add(mesh, Finish::polished_steel, cylinder(0.012, 0.05, 16), tap * at(0, 0.22, 0.19));
}

void add_hob(Mesh& mesh) {
  add(mesh, Finish::black_glass, box({0.6, 0.006, 0.52}, 0.002), at(kHobX, kCounterTop + 0.003, 0));
  for (const double x : {-0.14, 0.14}) {
    for (const double z : {-0.12, 0.12}) {
      const double radius = x * z > 0 ? 0.1 : 0.08;
      add(mesh, Finish::grey_plastic,
          lathe({{radius, 0}, {radius - 0.004, 0.0004}, {radius - 0.008, 0}}, 40),
          at(kHobX + x, kCounterTop + 0.0062, z));
    }
  }
}

void add_oven(Mesh& mesh, double front) {
  add(mesh, Finish::brushed_steel, box({0.596, 0.72, 0.02}, 0.003), at(kHobX, 0.49, front));
  add(mesh, Finish::black_glass, box({0.5, 0.42, 0.008}, 0.002), at(kHobX, 0.42, front + 0.012));
  add_handle(mesh, 0.5, at(kHobX, 0.69, front + 0.01) * about_z(90));
  for (const double x : {-0.2, -0.1, 0.1, 0.2}) {
    add(mesh, Finish::black_plastic, cylinder(0.018, 0.02, 20),
        at(kHobX + x, 0.79, front + 0.01) * about_x(90));
  }
}

void add_doors(Mesh& mesh, double front) {
  for (const double x : {-1.2, -0.6, 0.0, 1.2}) {
    add(mesh, Finish::door_paint, box({0.594, 0.72, 0.02}, 0.003), at(x, 0.49, front));
    add_handle(mesh, 0.2, at(x + 0.24, 0.7, front + 0.01));
  }
}

}  // namespace

Mesh counter() {
  Mesh mesh = {"counter", {}};
  const double body = kCounterDepth - 0.06;
  const double front = body / 2 + 0.005;
  add(mesh, Finish::white_paint, box({kCounterLength, 0.58, body}), at(0, 0.39, -0.02));
  add(mesh, Finish::white_paint, box({kCounterLength, 0.2, 0.02}), at(0, 0.78, body / 2 - 0.03));
  add(mesh, Finish::black_plastic, box({kCounterLength, 0.1, 0.5}), at(0, 0.05, -0.04));
  add_doors(mesh, front);
  add_oven(mesh, front);
  add_worktop(mesh);
  add_sink(mesh);
  add_hob(mesh);
  return mesh;
}

Mesh splashback() {
  Mesh mesh = {"splashback", {}};
  add(mesh, Finish::polished_steel, box({0.9, 0.62, 0.006}), at(0, 0.31, 0.004));
  return mesh;
}

Mesh hood() {
  Mesh mesh = {"hood", {}};
  add(mesh, Finish::brushed_steel, box({0.9, 0.06, 0.5}, 0.004), at(0, 0.03, 0.251));
  add(mesh, Finish::brushed_steel, box({0.28, 0.84, 0.26}, 0.004), at(0, 0.48, 0.132));
  for (int button = 0; button < 4; ++button) {
    add(mesh, Finish::black_plastic, box({0.02, 0.012, 0.006}),
        at(0.24 + 0.04 * button, 0.03, 0.503));
  }
  return mesh;
}

Mesh glass_cabinet() {
  constexpr double kHigh = 0.72;
  constexpr double kDeep = 0.34;
  Mesh mesh = {"glass_cabinet", {}};
  add(mesh, Finish::pine, plank({0.9, kHigh, 0.008}), at(0, kHigh / 2, 0.005));
  for (const double x : {-0.44, 0.44}) {
    add(mesh, Finish::pine, plank({0.02, kHigh, kDeep - 0.03}), at(x, kHigh / 2, kDeep / 2 - 0.01));
  }
  for (const double top : {kCabinetFloor, kCabinetShelf, kHigh}) {
    add(mesh, Finish::pine, plank({0.858, 0.018, kDeep - 0.04}),
        at(0, top - 0.009, kDeep / 2 - 0.01));
  }
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Isometry3d door = at(side * 0.225, kHigh / 2, kDeep - 0.01);
    for (const double x : {-0.2, 0.2}) {
      add(mesh, Finish::pine, plank({0.045, kHigh - 0.004, 0.018}), door * at(x, 0, 0));
    }
    for (const double y : {-0.335, 0.335}) {
      add(mesh, Finish::pine, plank({0.354, 0.045, 0.018}), door * at(0, y, 0));
    }
    add(mesh, Finish::window_glass, panel(0.358, 0.63), door);
    add_handle(mesh, 0.12, door * at(-side * 0.2, -0.2, 0.009));
  }
  return mesh;
}

Mesh fridge() {
  Mesh mesh = {"fridge", {}};
  add(mesh, Finish::grey_plastic, box({0.61, 1.85, 0.58}, 0.004), at(0, 0.93, -0.03));
  add(mesh, Finish::brushed_steel, box({0.62, 1.14, 0.05}, 0.008), at(0, 1.285, 0.29));
  add(mesh, Finish::brushed_steel, box({0.62, 0.66, 0.05}, 0.008), at(0, 0.375, 0.29));
  add_handle(mesh, 0.6, at(0.26, 1.15, 0.315));
  add_handle(mesh, 0.3, at(0.26, 0.5, 0.315));
  return mesh;
}

Mesh glass_table() {
  Mesh mesh = {"glass_table", {}};
  add(mesh, Finish::window_glass, rectangle({-0.65, 0.75, -0.4}, {1.3, 0, 0}, {0, 0, 0.8}));
  for (const double x : {-0.58, 0.58}) {
    for (const double z : {-0.33, 0.33}) {
      add(mesh, Finish::polished_steel, cylinder(0.022, 0.746, 24), at(x, 0, z));
    }
    add(mesh, Finish::brushed_steel, box({0.03, 0.03, 0.62}, 0.004), at(x, 0.72, 0));
  }
  for (const double z : {-0.33, 0.33}) {
    add(mesh, Finish::brushed_steel, box({1.12, 0.03, 0.03}, 0.004), at(0, 0.72, z));
  }
  return mesh;
}

Mesh patio_window(double width, double height) {
  constexpr double kBar = 0.07;
  Mesh mesh = {"patio_window", {}};
  for (const double x : {-width / 2 + kBar / 2, 0.0, width / 2 - kBar / 2}) {
    add(mesh, Finish::white_paint, box({kBar, height, 0.07}, 0.006), at(x, height / 2, 0));
  }
  for (const double y : {kBar / 2, height - kBar / 2}) {
    add(mesh, Finish::white_paint, box({width - 2 * kBar, kBar, 0.066}, 0.006), at(0, y, 0));
  }
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::window_glass, panel((width - 3 * kBar) / 2, height - 2 * kBar),
        at(side * (width - kBar) / 4, height / 2, 0));
  }
  add_handle(mesh, 0.16, at(0.012, 1.05, 0.036));
  return mesh;
}

Mesh wall_mirror() {
  Mesh mesh = {"wall_mirror", {}};
  add(mesh, Finish::mirror, panel(0.64, 1.24), at(0, 0, 0.014));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::walnut, plank({0.03, 1.3, 0.03}, 0.005), at(side * 0.335, 0, 0.016));
    add(mesh, Finish::walnut, plank({0.64, 0.03, 0.029}, 0.005), at(0, side * 0.635, 0.016));
  }
  return mesh;
}

Mesh wine_glass() {
  Mesh mesh = {"wine_glass", {}};
  add(mesh, Finish::window_glass,
      lathe({{0.034, 0.002},
             {0.006, 0.008},
             {0.004, 0.02},
             {0.004, 0.09},
             {0.02, 0.105},
             {0.038, 0.135},
             {0.04, 0.16},
             {0.032, 0.2}},
            28));
  return mesh;
}

Mesh cooking_pot() {
  Mesh mesh = {"cooking_pot", {}};
  add(mesh, Finish::polished_steel,
      lathe({{0, 0.001},
             {0.115, 0.001},
             {0.12, 0.008},
             {0.12, 0.008},
             {0.12, 0.13},
             {0.12, 0.13},
             {0.125, 0.134},
             {0.1, 0.15},
             {0.02, 0.162},
             {0, 0.162}},
            40));
  add(mesh, Finish::black_plastic, sphere(0.018, 16), at(0, 0.178, 0));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::black_plastic, soft_box({0.05, 0.016, 0.07}, 0.006, 2),
        at(side * 0.142, 0.1, 0));
  }
  return mesh;
}

Mesh ceiling_light() {
  Mesh mesh = {"ceiling_light", {}};
  add(mesh, Finish::white_paint, box({0.94, 0.04, 0.94}, 0.004), at(0, -0.019, 0));
  add(mesh, Finish::light_panel, rectangle({-0.45, -0.0395, 0.45}, {0.9, 0, 0}, {0, 0, -0.9}));
  return mesh;
}

}  // namespace scenes
