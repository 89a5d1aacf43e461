#include "vo/bootstrap/start_adjustment.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/plane_frames.h"
#include "vo/core/hash.h"

namespace {

using support::hash_noise;
using vo::mixed_uniform;
using vo::SE3;

constexpr double kFocal = 500;  // px
constexpr std::size_t kPlaces = 150;
constexpr std::size_t kViews = 8;

SE3 pose(std::size_t view) {
  const double far = static_cast<double>(view + 1) / kViews;
  vo::Vector6d xi;
  xi << 0.15 * far, -0.02 * far, 0.05 * far, 0.02 * far, -0.03 * far * far, 0.01;
  return SE3::exp(xi);
}

double inverse_depth(std::size_t place) {
  return 0.25 + 0.75 * mixed_uniform(3 * place);
}

Eigen::Vector2d ray(std::size_t place) {
  return {mixed_uniform(3 * place + 1) - 0.5, 0.75 * (mixed_uniform(3 * place + 2) - 0.5)};
}

/// What the views see, each place but every seventh in each, and guesses that are off.
vo::StartViews disturbed_start(double noise_px) {
  vo::StartViews start;
  for (std::size_t f = 0; f < kViews; ++f) {
    vo::StartView view;
    vo::Vector6d off;
    for (int i = 0; i < 6; ++i) {
      off[i] = 0.004 * hash_noise(1000 + 6 * f + static_cast<std::uint64_t>(i));
    }
    view.T_frame_first = f + 1 < kViews ? SE3::exp(off) * pose(f) : pose(f);
    for (std::size_t place = 0; place < kPlaces; ++place) {
      if ((place + f) % 7 != 0) {
        const Eigen::Vector2d seen =
            (pose(f) * Eigen::Vector3d(ray(place).homogeneous() / inverse_depth(place)))
                .hnormalized();
        const std::uint64_t noise = 5000 + 2 * (kPlaces * f + place);
        view.pairs.push_back(
            {ray(place),
             seen + noise_px / kFocal * Eigen::Vector2d(hash_noise(noise), hash_noise(noise + 1))});
        view.places.push_back(place);
        view.bend.emplace_back(0, 0);
      }
    }
    start.views.push_back(view);
  }
  for (std::size_t place = 0; place < kPlaces; ++place) {
    start.inverse_depth.push_back(inverse_depth(place) * (1 + 0.1 * hash_noise(9000 + place)));
  }
  return start;
}

double relative_depth_error(const vo::StartViews& start) {
  double squares = 0;
  for (std::size_t place = 0; place < kPlaces; ++place) {
    squares += std::pow(start.inverse_depth[place] / inverse_depth(place) - 1, 2);
  }
  return std::sqrt(squares / kPlaces);
}

TEST(StartAdjustment, FindsWhatExactViewsSaw) {
  vo::StartViews start = disturbed_start(0);
  EXPECT_GT(relative_depth_error(start), 0.03);
  vo::adjust(start, 0.7 / kFocal);
  EXPECT_LT(relative_depth_error(start), 1e-5);
  for (std::size_t f = 0; f < kViews; ++f) {
    EXPECT_LT((start.views[f].T_frame_first.inverse() * pose(f)).log().norm(), 1e-5) << f;
  }
}

/// Eight views of growing parallax, 1 + 4 + ... + 64 in squares against 64 of the last alone.
TEST(StartAdjustment, ManyViewsAreMorePreciseThanTheLastAlone) {
  constexpr double kNoisePx = 0.3;
  vo::StartViews all = disturbed_start(kNoisePx);
  vo::StartViews last{{all.views.back()}, all.inverse_depth};
  vo::adjust(all, 0.7 / kFocal);
  vo::adjust(last, 0.7 / kFocal);
  EXPECT_LT(relative_depth_error(all), 0.8 * relative_depth_error(last));
}

TEST(StartAdjustment, HoldsTheScale) {
  vo::StartViews start = disturbed_start(0.3);
  const double length = start.views.back().T_frame_first.translation().norm();
  vo::adjust(start, 0.7 / kFocal);
  EXPECT_NEAR(start.views.back().T_frame_first.translation().norm(), length, 1e-12);
}

}  // namespace
