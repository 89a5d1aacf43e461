#include "vo/bootstrap/start_shutter.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "vo/bootstrap/start_adjustment.h"
#include "vo/core/fields.h"
#include "vo/core/hash.h"

namespace {

using vo::mixed_uniform;
using vo::SE3;

constexpr double kFocalPx = 500;  // px
const Eigen::Vector2d kSizePx(640, 480);
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
  double past_middle = 0;  ///< of the line, as a share of the image's height or width
};

Sight sight_of(const Eigen::Vector3d& p_world, double t, const vo::Readout& readout) {
  const int across = readout.axis == vo::ReadoutAxis::rows ? 1 : 0;
  Sight sight;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d p =
        T_world_camera(t + readout.seconds * sight.past_middle).inverse() * p_world;
    sight = {p.hnormalized(), 1 / p.z(), p[across] / p.z() * kFocalPx / kSizePx[across]};
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
/// Returns a start whose read-out time is unknown.
vo::StartViews rolling_start(const vo::Readout& readout) {
  vo::StartViews start;
  start.readout.axis = readout.axis;
  const int across = readout.axis == vo::ReadoutAxis::rows ? 1 : 0;
  start.views.resize(kRollingFrames - 1);
  for (std::size_t place = 0; place < kPointsSeen; ++place) {
    const Sight first = sight_of(point_in_world(place), 0, readout);
    start.inverse_depth.push_back(first.inverse_depth * (0.9 + 0.2 * mixed_uniform(9000 + place)));
    for (std::size_t f = 1; f < kRollingFrames; ++f) {
      const double t = kInterval * static_cast<double>(f);
      const Sight seen = sight_of(point_in_world(place), t, readout);
      vo::StartView& view = start.views[f - 1];
      view.T_frame_first = T_world_camera(t).inverse() * T_world_camera(0);
      vo::RayPair& pair = view.pairs.emplace_back(vo::RayPair{first.ray, seen.ray});
      pair.first_from_middle[across] = first.past_middle;
      pair.second_from_middle[across] = seen.past_middle;
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
  const vo::StartViews start = rolling_start({});
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
  for (const vo::ReadoutAxis axis : {vo::ReadoutAxis::rows, vo::ReadoutAxis::columns}) {
    for (const double seconds : {0.01, 0.026, -0.026}) {
      vo::StartViews start = rolling_start({seconds, axis});
      adjust_with_shutter(start);
      EXPECT_NEAR(start.readout.seconds, seconds, 0.1 * std::abs(seconds)) << vo::to_string(axis);
    }
  }
}

TEST(StartShutter, AGlobalShutterIsFoundToBeOne) {
  vo::StartViews start = rolling_start({});
  adjust_with_shutter(start);
  EXPECT_NEAR(start.readout.seconds, 0, 1e-4);
}

/// Returns the root mean square of the relative depth errors, apart from the common scale.
double depth_spread(const vo::StartViews& start, const vo::Readout& readout) {
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
  constexpr vo::Readout kReadout{.seconds = 0.026};
  vo::StartViews found = rolling_start(kReadout);
  adjust_with_shutter(found);
  vo::StartViews as_if_global = rolling_start(kReadout);
  as_if_global.readout_is_known = true;
  adjust_with_shutter(as_if_global);
  EXPECT_EQ(as_if_global.readout.seconds, 0);
  EXPECT_LT(3 * depth_spread(found, kReadout), depth_spread(as_if_global, kReadout));
}

}  // namespace
