#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tools/make_scenes/model/model_builder.h"
#include "tools/make_scenes/model/periodic_motion.h"
#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/scenes/gait.h"
#include "tools/make_scenes/scenes/scenes.h"

namespace scenes {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The body, m. It faces +z.
constexpr double kKneeHeight = 0.47;
constexpr double kWaistHeight = 1.02;
constexpr double kShoulderX = 0.225;
constexpr double kElbowHeight = 1.12;

constexpr Period kPeriod = {.duration = kTwoSteps, .steps = 20};  // s, at 1 m/s

const Color kTrousers(0.05, 0.08, 0.2);
const Color kShirt(0.7, 0.2, 0.1);
const Color kSkin(0.6, 0.36, 0.25);
const Color kShoes(0.06, 0.05, 0.05);

/// The nodes that bend the body and where they are in the pose that it is bound in.
class Skeleton {
 public:
  explicit Skeleton(ModelBuilder& scene) : scene_(scene) { skin_.name = "walker"; }

  /// Adds a joint that moves about itself by `turn` of the phase, and returns its number in the
  /// skin.
  template <typename Turn>
  int add(int parent, const std::string& name, const Vector3d& place, Turn turn) {
    const bool is_root = parent == kNone;
    const auto above = static_cast<std::size_t>(is_root ? 0 : parent);
    const Vector3d offset = is_root ? place : Vector3d(place - skin_.joints_in_mesh[above]);
    const int node =
        scene_.add_group(is_root ? kNone : skin_.joints[above], name, Isometry3d::Identity());
    scene_.add_motion(periodic_motion(node, kPeriod, [=](double phase) {
      return at(offset.x(), offset.y(), offset.z()) * turn(phase);
    }));
    skin_.joints.push_back(node);
    skin_.joints_in_mesh.push_back(place);
    return static_cast<int>(skin_.joints.size()) - 1;
  }

  const Skin& skin() const { return skin_; }

 private:
  ModelBuilder& scene_;
  Skin skin_;
};

/// A place where a part of the body bends: what is above follows one joint, what is below another.
struct Bend {
  int above = 0;
  int below = 0;
  double height = 0;      ///< m
  double half_width = 0;  ///< m of the blend between both
};

void add_bent(Mesh& mesh, const Shape& shape, const Isometry3d& T_mesh_shape, const Bend& bend) {
  Shape placed;
  append(placed, shape, T_mesh_shape);
  for (const Vector3d& position : placed.positions) {
    const double weight =
        smooth_step(bend.height - bend.half_width, bend.height + bend.half_width, position.y());
    placed.joints.push_back({bend.above, bend.below, weight});
  }
  add(mesh, Finish::paint, placed);
}

/// Adds a part that follows one joint.
void add_rigid(Mesh& mesh, const Shape& shape, const Isometry3d& T_mesh_shape, int joint) {
  add_bent(mesh, shape, T_mesh_shape, {joint, joint, -1, 0.5});  // a bend below the ground
}

void add_leg(Skeleton& skeleton, int hips, double side, Mesh& mesh) {
  const std::string name = side < 0 ? "right_" : "left_";
  const int thigh =
      skeleton.add(hips, name + "thigh", {side * kHipX, kHipHeight, 0},
                   [side](double phase) { return about_x(-side * kHipSwing * std::sin(phase)); });
  const int shin = skeleton.add(
      thigh, name + "shin", {side * kHipX, kKneeHeight, 0},
      [side](double phase) { return about_x(kKneeSwing * std::max(side * std::cos(phase), 0.0)); });
  const Shape leg = lathe({{0.042, 0.06},
                           {0.055, 0.25},
                           {0.06, kKneeHeight - 0.07},
                           {0.064, kKneeHeight},
                           {0.068, kKneeHeight + 0.07},
                           {0.085, 0.74},
                           {0.08, 0.92},
                           {0, 0.95}},
                          7);
  add_bent(mesh, painted(leg, kTrousers), at(side * kHipX, 0, 0), {thigh, shin, kKneeHeight, 0.08});
  add_rigid(mesh, painted(box({0.095, 0.08, 0.27}), kShoes), at(side * kHipX, 0.04, 0.05), shin);
}

void add_arm(Skeleton& skeleton, int chest, double side, Mesh& mesh) {
  const std::string name = side < 0 ? "right_" : "left_";
  const int shoulder = skeleton.add(
      chest, name + "upper_arm", {side * kShoulderX, kShoulderHeight, 0}, [side](double phase) {
        return about_z(side * 4) * about_x(side * kShoulderSwing * std::sin(phase));
      });
  const int elbow =
      skeleton.add(shoulder, name + "forearm", {side * kShoulderX, kElbowHeight, 0},
                   [side](double phase) { return about_x(-24 + 10 * side * std::sin(phase)); });
  const Shape sleeve = lathe({{0.036, 0.9},
                              {0.045, kElbowHeight - 0.06},
                              {0.05, kElbowHeight},
                              {0.052, kElbowHeight + 0.06},
                              {0.058, 1.36},
                              {0, 1.45}},
                             7);
  const Bend bend = {shoulder, elbow, kElbowHeight, 0.07};
  add_bent(mesh, painted(sleeve, kShirt), at(side * kShoulderX, 0, 0), bend);
  add_rigid(mesh, painted(stretched(sphere(0.06, 6), {0.6, 1.5, 0.9}), kSkin),
            at(side * kShoulderX, 0.84, 0), elbow);
}

void add_trunk(int hips, int chest, Mesh& mesh) {
  const Vector3d flat(1, 1, 0.64);
  const Shape trousers = lathe({{0, 0.8}, {0.15, 0.86}, {0.17, 0.93}, {0.16, 1.0}}, 10);
  const Shape shirt = lathe({{0.168, 0.96},
                             {0.158, kWaistHeight + 0.06},
                             {0.185, 1.3},
                             {0.17, 1.42},
                             {0.06, 1.47},
                             {0, 1.475}},
                            10);
  const Bend waist = {chest, hips, kWaistHeight, 0.1};
  add_bent(mesh, painted(stretched(trousers, flat), kTrousers), Isometry3d::Identity(), waist);
  add_bent(mesh, painted(stretched(shirt, flat), kShirt), Isometry3d::Identity(), waist);
  add_rigid(mesh, painted(stretched(sphere(0.11, 8), {0.8, 1.25, 1}), kSkin), at(0, 1.6, 0.01),
            chest);
}

}  // namespace

Model make_walker() {
  ModelBuilder scene("walker");
  Skeleton skeleton(scene);
  Mesh body = {"walker", {}};
  const int hips = skeleton.add(kNone, "hips", {0, kHipHeight, 0}, [](double phase) {
    return at(0, -kBob * std::sin(phase) * std::sin(phase), 0);
  });
  const int chest = skeleton.add(hips, "chest", {0, kWaistHeight, 0},
                                 [](double phase) { return about_y(6 * std::sin(phase)); });
  add_trunk(hips, chest, body);
  for (const double side : {-1.0, 1.0}) {
    add_leg(skeleton, hips, side, body);
    add_arm(skeleton, chest, side, body);
  }
  scene.place_skinned("walker", scene.add_mesh(body), skeleton.skin());
  return scene.model();
}

}  // namespace scenes
