#include "tools/make_scenes/scenes/visitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tools/make_scenes/model/periodic_motion.h"
#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/scenes/gait.h"

namespace scenes {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The body, m. It faces +z.
constexpr double kThigh = 0.43;
constexpr double kShoulderX = 0.215;
constexpr double kUpperArm = 0.28;

// The walk.
constexpr Period kPeriod = {.duration = kVisitorPeriod, .steps = 128};
constexpr double kTurnTime = 0.6;   // s, at either end
constexpr double kStartTime = 0.4;  // s to reach the full speed, and to stop

void add_clothed_trunk(Mesh& mesh) {
  const Vector3d flat(1, 1, 0.64);
  add(mesh, Finish::trousers,
      stretched(lathe({{0, 0.8}, {0.12, 0.82}, {0.165, 0.88}, {0.17, 0.93}, {0.165, 0.98}}, 28),
                flat));
  add(mesh, Finish::tartan,
      stretched(lathe({{0.155, 0.915},
                       {0.176, 0.92},
                       {0.165, 1.0},
                       {0.155, 1.08},
                       {0.165, 1.18},
                       {0.184, 1.3},
                       {0.19, 1.37},
                       {0.17, 1.42},
                       {0.1, 1.458},
                       {0.06, 1.475},
                       {0, 1.475}},
                      32),
                flat));
}

void add_head(Mesh& mesh) {
  add(mesh, Finish::skin, cylinder(0.052, 0.12, 16), at(0, 1.44, 0));
  add(mesh, Finish::skin, stretched(sphere(0.1, 24), {0.78, 1.2, 0.98}), at(0, 1.62, 0.012));
  add(mesh, Finish::hair, stretched(sphere(0.106, 24), {0.81, 1.0, 0.98}), at(0, 1.644, -0.006));
  add(mesh, Finish::skin, stretched(sphere(0.02, 10), {0.8, 1.4, 1.2}), at(0, 1.605, 0.107));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::skin, stretched(sphere(0.024, 10), {0.5, 1.4, 0.9}),
        at(side * 0.084, 1.61, 0.005));
    add(mesh, Finish::black_plastic, sphere(0.011, 8), at(side * 0.03, 1.635, 0.096));
  }
}

void add_backpack(Mesh& mesh) {
  const Isometry3d pack = at(0, 1.2, -0.19);
  add(mesh, Finish::ochre_fabric, soft_box({0.28, 0.42, 0.15}, 0.05), pack);
  add(mesh, Finish::shapes_poster, panel(0.19, 0.26), pack * about_y(180) * at(0, 0.01, 0.0755));
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::rust_fabric, soft_box({0.03, 0.24, 0.12}, 0.014),
        pack * at(side * 0.142, -0.06, 0));
    add(mesh, Finish::black_plastic, box({0.035, 0.32, 0.01}, 0.003), at(side * 0.1, 1.29, 0.098));
    add(mesh, Finish::black_plastic, box({0.035, 0.014, 0.22}, 0.003),
        at(side * 0.1, 1.447, -0.005));
  }
}

/// Returns everything but the limbs; the feet would stand on y = 0.
Mesh trunk() {
  Mesh mesh = {"visitor_trunk", {}};
  add_clothed_trunk(mesh);
  add_head(mesh);
  add_backpack(mesh);
  return mesh;
}

/// Returns a thigh that hangs down from the hip at the origin.
Mesh thigh() {
  Mesh mesh = {"visitor_thigh", {}};
  add(mesh, Finish::trousers,
      lathe({{0, -0.49},
             {0.045, -0.475},
             {0.062, -kThigh},
             {0.07, -0.3},
             {0.085, -0.1},
             {0.086, 0},
             {0.06, 0.06},
             {0, 0.08}},
            20));
  return mesh;
}

/// Returns a shin with its shoe, from the knee at the origin down to the sole.
Mesh shin() {
  Mesh mesh = {"visitor_shin", {}};
  add(mesh, Finish::trousers,
      lathe({{0, -0.41},
             {0.055, -0.41},
             {0.055, -0.41},
             {0.055, -0.3},
             {0.064, -0.13},
             {0.062, 0},
             {0.045, 0.045},
             {0, 0.06}},
            20));
  add(mesh, Finish::rust_fabric, soft_box({0.095, 0.08, 0.27}, 0.035), at(0, -0.42, 0.05));
  add(mesh, Finish::porcelain, soft_box({0.1, 0.025, 0.28}, 0.012), at(0, -0.456, 0.05));
  return mesh;
}

/// Returns an arm, slightly bent, that hangs down from the shoulder at the origin.
Mesh arm() {
  Mesh mesh = {"visitor_arm", {}};
  add(mesh, Finish::tartan,
      lathe({{0, -0.325},
             {0.036, -0.31},
             {0.045, -0.26},
             {0.052, -0.1},
             {0.055, -0.02},
             {0.045, 0.035},
             {0, 0.055}},
            18));
  const Isometry3d forearm = at(0, -kUpperArm, 0) * about_x(-24);
  add(mesh, Finish::tartan,
      lathe({{0, -0.22},
             {0.036, -0.22},
             {0.036, -0.22},
             {0.045, -0.08},
             {0.045, 0},
             {0.03, 0.035},
             {0, 0.045}},
            18),
      forearm);
  add(mesh, Finish::skin, stretched(sphere(0.05, 14), {0.55, 1.7, 0.9}),
      forearm * at(0, -0.285, 0.005));
  return mesh;
}

/// Returns how far a speed that rises evenly from 0 to 1 within kStartTime has led after `time`.
double started_distance(double time) {
  const double start = std::clamp(time, 0.0, kStartTime);
  return start * start / (2 * kStartTime) + std::max(time - kStartTime, 0.0);
}

double started_speed(double time) {
  return std::clamp(time / kStartTime, 0.0, 1.0);
}

/// A moment of the walk.
struct Stride {
  double z = 0;            ///< m
  double heading_deg = 0;  ///< about y
  double phase = 0;        ///< of two steps, rad
  double vigour = 0;       ///< speed over the full speed
};

Stride stride(double phase) {
  const double halves = phase / std::numbers::pi;
  const double half = std::min(std::floor(halves), 1.0);
  const double way = half == 0 ? 1 : -1;
  const double time = (halves - half) * kVisitorPeriod / 2;
  const double walking_time = kVisitorPeriod / 2 - kTurnTime;
  const double stop = walking_time - kStartTime;
  const double speed = kVisitorWalk / stop;
  const double distance = speed * (started_distance(time) - started_distance(time - stop));
  return {.z = way * (distance - kVisitorWalk / 2),
          .heading_deg = 180 * (half + smooth_step(walking_time, kVisitorPeriod / 2, time)),
          .phase = 2 * std::numbers::pi * distance / kTwoSteps,
          .vigour = started_speed(time) - started_speed(time - stop)};
}

/// Indices of the limbs' meshes, which both sides share.
struct Limbs {
  int thigh, shin, arm;
};

void add_leg(ModelBuilder& scene, int body, const Limbs& limbs, double side) {
  const std::string name = side < 0 ? "right_" : "left_";
  const int hip = scene.place(body, name + "thigh", limbs.thigh, Isometry3d::Identity());
  scene.add_motion(periodic_motion(hip, kPeriod, [side](double phase) {
    const Stride now = stride(phase);
    return at(side * kHipX, kHipHeight, 0) *
           about_x(-side * kHipSwing * now.vigour * std::sin(now.phase));
  }));
  const int knee = scene.place(hip, name + "shin", limbs.shin, Isometry3d::Identity());
  scene.add_motion(periodic_motion(knee, kPeriod, [side](double phase) {
    const Stride now = stride(phase);
    return at(0, -kThigh, 0) *
           about_x(kKneeSwing * now.vigour * std::max(side * std::cos(now.phase), 0.0));
  }));
}

void add_arm(ModelBuilder& scene, int body, const Limbs& limbs, double side) {
  const std::string name = side < 0 ? "right_arm" : "left_arm";
  const int shoulder = scene.place(body, name, limbs.arm, Isometry3d::Identity());
  scene.add_motion(periodic_motion(shoulder, kPeriod, [side](double phase) {
    const Stride now = stride(phase);
    return at(side * kShoulderX, kShoulderHeight, 0) * about_z(side * 4) *
           about_x(side * kShoulderSwing * now.vigour * std::sin(now.phase));
  }));
}

}  // namespace

void add_visitor(ModelBuilder& scene, int parent) {
  const int body = scene.place(parent, "visitor", scene.add_mesh(trunk()), Isometry3d::Identity());
  scene.add_motion(periodic_motion(body, kPeriod, [](double phase) {
    const Stride now = stride(phase);
    const double apart = now.vigour * std::sin(now.phase) * std::sin(now.phase);
    return at(0, -kBob * apart, now.z) * about_y(now.heading_deg);
  }));
  const Limbs limbs = {scene.add_mesh(thigh()), scene.add_mesh(shin()), scene.add_mesh(arm())};
  for (const double side : {-1.0, 1.0}) {
    add_leg(scene, body, limbs, side);
    add_arm(scene, body, limbs, side);
  }
}

}  // namespace scenes
