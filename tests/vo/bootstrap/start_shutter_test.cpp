#include "vo/bootstrap/start_shutter.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "vo/bootstrap/start_adjustment.h"
#include "vo/core/hash.h"

namespace {

using vo::mixed_uniform;
using vo::SE3;

constexpr double kFocalPx = 500;    // px
constexpr double kHeightPx = 480;   // px
constexpr double kInterval = 0.03;  // s
constexpr std::size_t kPointsSeen = 150;
constexpr std::size_t kRollingFrames = 13;

/// A hand's motion: it shakes while it moves on.
SE3 T_world_camera(double t) {
  vo::Vector6d xi;
  xi << 0.4 * t, 0.02 * std::sin(9 * t), 0.1 * t, 0.03 * std::sin(11 * t), 0.05 * std::sin(7 * t),
      0.04 * std::cos(12 * t);
  return SE3::exp(xi);
}

/// A point as a rolling-shutter camera sees it in the row that is read at that time.
struct Sight {
  Eigen::Vector2d ray{0, 0};
  double inverse_depth = 0;
  double row = 0;  ///< image heights below the middle
};

Sight sight_of(const Eigen::Vector3d& p_world, double t, double readout) {
  Sight sight;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d p = T_world_camera(t + readout * sight.row).inverse() * p_world;
    sight = {p.hnormalized(), 1 / p.z(), p.y() / p.z() * kFocalPx / kHeightPx};
  }
  return sight;
}

Eigen::Vector3d point_in_world(std::size_t place) {
  const double depth = 1.5 + 2 * mixed_uniform(3 * place);
  const Eigen::Vector3d p(depth * (mixed_uniform(3 * place + 1) - 0.5),
                          depth * (mixed_uniform(3 * place + 2) - 0.5), depth);
  return T_world_camera(0.5 * kInterval * kRollingFrames) * p;
}

/// Exact views with a rolling shutter; poses are those of the middle rows, depths a tenth off.
vo::StartViews rolling_start(double readout) {
  vo::StartViews start;
  start.views.resize(kRollingFrames - 1);
  for (std::size_t place = 0; place < kPointsSeen; ++place) {
    const Sight first = sight_of(point_in_world(place), 0, readout);
    start.inverse_depth.push_back(first.inverse_depth * (0.9 + 0.2 * mixed_uniform(9000 + place)));
    for (std::size_t f = 1; f < kRollingFrames; ++f) {
      const double t = kInterval * static_cast<double>(f);
      const Sight seen = sight_of(point_in_world(place), t, readout);
      vo::StartView& view = start.views[f - 1];
      view.T_frame_first = T_world_camera(t).inverse() * T_world_camera(0);
      view.pairs.push_back({first.ray, seen.ray, first.row, seen.row});
      view.places.push_back(place);
    }
  }
  return start;
}

std::vector<double> times_of_frames() {
  std::vector<double> timestamps;
  for (std::size_t f = 0; f < kRollingFrames; ++f) {
    timestamps.push_back(kInterval * static_cast<double>(f));
  }
  return timestamps;
}

void adjust_with_shutter(vo::StartViews& start) {
  const std::vector<double> timestamps = times_of_frames();
  for (int round = 0; round < 4; ++round) {
    vo::bend_pairs(vo::start_velocities(start, timestamps), start);
    vo::adjust(start, 0.7 / kFocalPx);
  }
}

TEST(StartShutter, VelocitiesAreThoseOfTheMotion) {
  const vo::StartViews start = rolling_start(0);
  const std::vector<double> timestamps = times_of_frames();
  const std::vector<vo::Vector6d> velocities = vo::start_velocities(start, timestamps);
  ASSERT_EQ(velocities.size(), kRollingFrames);
  constexpr double kStep = 1e-4;
  for (std::size_t f = 1; f + 1 < kRollingFrames; ++f) {
    const double t = timestamps[f];
    const vo::Vector6d truth =
        (T_world_camera(t - kStep).inverse() * T_world_camera(t + kStep)).log() / (2 * kStep);
    EXPECT_LT((velocities[f] - truth).norm(), 0.05 * truth.norm()) << f;
  }
}

TEST(StartShutter, FindsTheReadOutTime) {
  for (const double readout : {0.01, 0.026}) {
    vo::StartViews start = rolling_start(readout);
    adjust_with_shutter(start);
    EXPECT_NEAR(start.readout, readout, 0.1 * readout);
  }
}

TEST(StartShutter, AGlobalShutterIsFoundToBeOne) {
  vo::StartViews start = rolling_start(0);
  adjust_with_shutter(start);
  EXPECT_NEAR(start.readout, 0, 1e-4);
}

/// Returns the root mean square of the relative depth errors, apart from the common scale.
double depth_spread(const vo::StartViews& start, double readout) {
  double sum = 0;
  double squares = 0;
  for (std::size_t place = 0; place < kPointsSeen; ++place) {
    const double truth = sight_of(point_in_world(place), 0, readout).inverse_depth;
    const double ratio = std::log(start.inverse_depth[place] / truth);
    sum += ratio / kPointsSeen;
    squares += ratio * ratio / kPointsSeen;
  }
  return std::sqrt(squares - sum * sum);
}

TEST(StartShutter, DepthsFollow) {
  constexpr double kReadout = 0.026;
  vo::StartViews found = rolling_start(kReadout);
  adjust_with_shutter(found);
  vo::StartViews as_if_global = rolling_start(kReadout);
  as_if_global.readout_is_known = true;
  adjust_with_shutter(as_if_global);
  EXPECT_EQ(as_if_global.readout, 0);
  EXPECT_LT(3 * depth_spread(found, kReadout), depth_spread(as_if_global, kReadout));
}

}  // namespace
