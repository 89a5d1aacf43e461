#include "synth/gltf/actor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

// Keys are in single precision, which at the longest path's end has steps of 1 ms.
constexpr double kLongest = 1e4;        // s
constexpr double kShortestLeg = 0.02;   // s
constexpr double kShortestTurn = 0.01;  // s

/// A straight part of a path.
struct Leg {
  double begin = 0;     ///< s after the actor has set out
  double duration = 0;  ///< s
  double yaw = 0;       ///< rad, of +z towards +x
};

std::vector<Eigen::Vector3d> way_points(const ActorOptions& options) {
  std::vector<Eigen::Vector3d> points = options.path;
  if (options.loop) {
    points.push_back(points.front());
  }
  return points;
}

/// Returns the legs of a path; upright ones keep the direction of the one before.
std::vector<Leg> legs_of(const ActorOptions& options) {
  const std::vector<Eigen::Vector3d> points = way_points(options);
  std::vector<Leg> legs;
  double time = 0;
  double yaw = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Eigen::Vector3d way = points[i + 1] - points[i];
    yaw = way.x() != 0 || way.z() != 0 ? std::atan2(way.x(), way.z()) : yaw;
    legs.push_back({time, way.norm() / options.speed, yaw});
    time += legs.back().duration;
  }
  return legs;
}

AnimationChannel places_of(const ActorOptions& options, int node) {
  AnimationChannel channel{.node = node, .property = AnimatedProperty::translation};
  channel.curve.width = 3;
  const std::vector<Leg> legs = legs_of(options);
  const std::vector<Eigen::Vector3d> points = way_points(options);
  for (std::size_t i = 0; i < points.size(); ++i) {
    channel.curve.times.push_back(static_cast<float>(
        i < legs.size() ? legs[i].begin : legs.back().begin + legs.back().duration));
    for (const double coordinate : points[i]) {
      channel.curve.values.push_back(static_cast<float>(coordinate));
    }
  }
  return channel;
}

/// The keys of an actor's direction.
class Turning {
 public:
  explicit Turning(int node) {
    channel_.node = node;
    channel_.property = AnimatedProperty::rotation;
    channel_.curve.width = 4;
    channel_.curve.holds_quaternions = true;
  }

  void add(double time, double yaw) {
    channel_.curve.times.push_back(static_cast<float>(time));
    for (const double c : {0.0, std::sin(yaw / 2), 0.0, std::cos(yaw / 2)}) {
      channel_.curve.values.push_back(static_cast<float>(c));
    }
  }

  AnimationChannel channel() const { return channel_; }

 private:
  AnimationChannel channel_;
};

/// Returns the angle, rad, of the shorter turn from one direction to another.
double turn_between(const Leg& before, const Leg& after) {
  return std::remainder(after.yaw - before.yaw, 2 * std::numbers::pi);
}

/// Returns half the time, s, of the turn between two legs, of which each leaves time to go
/// straight.
double half_turn_time(const ActorOptions& options, const Leg& before, const Leg& after) {
  constexpr double kShare = 0.4;
  return std::min(options.turn_time / 2, kShare * std::min(before.duration, after.duration));
}

AnimationChannel directions_of(const ActorOptions& options, int node) {
  const std::vector<Leg> legs = legs_of(options);
  Turning turning(node);
  const Leg& first = legs.front();
  const Leg& last = legs.back();
  const double wrap = options.loop ? half_turn_time(options, last, first) : 0;
  const double turn = options.loop ? turn_between(last, first) : 0;
  turning.add(0, first.yaw - turn / 2);
  if (options.loop) {
    turning.add(wrap, first.yaw);
  }
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const Leg& before = legs[i - 1];
    const Leg& after = legs[i];
    const double half = half_turn_time(options, before, after);
    turning.add(after.begin - half, before.yaw);
    turning.add(after.begin, before.yaw + turn_between(before, after) / 2);
    turning.add(after.begin + half, after.yaw);
  }
  const double end = last.begin + last.duration;
  if (options.loop) {
    turning.add(end - wrap, last.yaw);
  }
  turning.add(end, last.yaw + turn / 2);
  return turning.channel();
}

}  // namespace

void ActorOptions::validate() const {
  require(!file.empty(), "actor: file: expected a glTF file");
  require(std::isfinite(speed) && speed > 0, "actor: speed: is ", speed,
          ", expected a positive number of m/s");
  require(std::isfinite(scale) && scale > 0, "actor: scale: is ", scale,
          ", expected a positive number");
  require(std::isfinite(start), "actor: start: is ", start, ", expected a number of s");
  require(std::isfinite(turn_time) && turn_time >= kShortestTurn, "actor: turn_time: is ",
          turn_time, ", expected at least ", kShortestTurn, " s");
  require(path.size() >= 2, "actor: path: has ", path.size(),
          " points, expected at least two, [[x, y, z], ...]");
  const std::vector<Eigen::Vector3d> points = way_points(*this);
  double length = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double step = (points[i + 1] - points[i]).norm();
    require(std::isfinite(step) && step / speed >= kShortestLeg, "actor: path: points ", i, " and ",
            (i + 1) % path.size(), " are ", step, " m apart, expected at least the ",
            kShortestLeg * speed, " m that it goes in ", kShortestLeg, " s");
    length += step;
  }
  require(length / speed <= kLongest, "actor: its path takes ", length / speed,
          " s, expected at most ", kLongest);
}

Animation walk_of(const ActorOptions& options, int node) {
  const Leg last = legs_of(options).back();
  return {.name = "path",
          .duration = last.begin + last.duration,
          .channels = {places_of(options, node), directions_of(options, node)},
          .start = options.start,
          .loops = options.loop};
}

}  // namespace synth
