#include "tools/make_scenes/furniture/lamps.h"

namespace scenes {

Mesh pendant_lamp() {
  Mesh mesh = {"pendant_lamp", {}};
  add(mesh, Finish::brass, lathe({{0, -0.03}, {0.045, -0.03}, {0.06, 0}}, 20));
  add(mesh, Finish::black_plastic, cylinder(0.004, 0.36, 8), at(0, -0.38, 0));
  add(mesh, Finish::brass, cylinder(0.024, 0.06, 16), at(0, -0.44, 0));
  add(mesh, Finish::lamp_shade,
      lathe({{0.16, -0.515}, {0.162, -0.51}, {0.13, -0.46}, {0.08, -0.42}, {0, -0.4}}, 32));
  add(mesh, Finish::lamp_glow, sphere(0.04, 20), at(0, -0.48, 0));
  return mesh;
}

Mesh floor_lamp() {
  Mesh mesh = {"floor_lamp", {}};
  add(mesh, Finish::steel,
      lathe({{0.15, 0.001},
             {0.15, 0.012},
             {0.15, 0.012},
             {0.13, 0.022},
             {0.03, 0.03},
             {0.011, 0.05},
             {0.011, 1.62}},
            28));
  add(mesh, Finish::lamp_shade,
      lathe({{0.011, 1.62},
             {0.06, 1.63},
             {0.13, 1.68},
             {0.17, 1.77},
             {0.17, 1.77},
             {0.165, 1.772},
             {0.165, 1.772},
             {0.126, 1.69},
             {0.058, 1.642},
             {0, 1.635}},
            32));
  add(mesh, Finish::lamp_glow, sphere(0.045, 16), at(0, 1.7, 0));
  return mesh;
}

Mesh table_lamp() {
  Mesh mesh = {"table_lamp", {}};
  add(mesh, Finish::glaze,
      lathe({{0.05, 0.001},
             {0.055, 0.01},
             {0.05, 0.03},
             {0.085, 0.09},
             {0.08, 0.15},
             {0.03, 0.2},
             {0.022, 0.24},
             {0, 0.24}},
            24));
  add(mesh, Finish::brass, cylinder(0.008, 0.08, 10), at(0, 0.235, 0));
  add(mesh, Finish::lamp_shade, lathe({{0.13, 0.25}, {0.085, 0.42}}, 28));
  return mesh;
}

}  // namespace scenes
