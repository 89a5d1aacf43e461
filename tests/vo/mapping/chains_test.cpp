#include "vo/mapping/chains.h"

#include <gtest/gtest.h>

#include "tests/support/plane_map.h"

namespace {

constexpr int kEnds = 12;  // px from the border: neighbours on both sides

/// A vertical edge in the middle of a small image.
vo::Hypotheses vertical_edge() {
  const vo::PinholeCamera camera = support::small_camera();
  vo::ByteImage image(camera.height, camera.width, std::uint8_t{50});
  image.colRange(camera.width / 2, camera.width).setTo(200);
  const vo::RgbdFrame frame{0, image, {}};
  vo::FramePyramid pyramid = vo::build_pyramid(frame, camera, vo::PyramidOptions());
  vo::add_edges(pyramid, vo::EdgeOptions());
  return vo::edge_hypotheses(pyramid.levels[0], {}, 0.5F);
}

/// Inverse depths that grow by 0.1 % per px down the edge, with these errors in turn.
void give_line(vo::Hypotheses& hypotheses, float error) {
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const auto v = static_cast<float>(hypotheses.pixel[i].y);
    const float sign = hypotheses.pixel[i].y % 2 == 0 ? 1.0F : -1.0F;
    hypotheses.set(i, 0.5F * (1 + 0.001F * v) + sign * error, 1e-4F);
  }
}

TEST(SmoothAlongChains, KeepsAStraightEdgeAsItIs) {
  vo::Hypotheses hypotheses = vertical_edge();
  ASSERT_GT(hypotheses.size(), 50U);
  give_line(hypotheses, 0);
  vo::smooth_along_chains(hypotheses);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    const int v = hypotheses.pixel[i].y;
    const bool is_inside = v > kEnds && v < support::small_camera().height - kEnds;
    EXPECT_NEAR(hypotheses.smoothed[i], hypotheses.inverse_depth[i], is_inside ? 1e-5 : 1e-3);
  }
}

TEST(SmoothAlongChains, TakesErrorsThatAlternateAway) {
  constexpr float kError = 0.005F;
  vo::Hypotheses hypotheses = vertical_edge();
  give_line(hypotheses, kError);
  vo::smooth_along_chains(hypotheses);
  const std::size_t middle = hypotheses.size() / 2;
  const float truth = 0.5F * (1 + 0.001F * static_cast<float>(hypotheses.pixel[middle].y));
  EXPECT_NEAR(hypotheses.inverse_depth[middle], truth, 1.01 * kError);
  EXPECT_NEAR(hypotheses.smoothed[middle], truth, 0.2 * kError);
  EXPECT_LT(hypotheses.smoothed_variance[middle], 0.5F * hypotheses.variance[middle]);
}

TEST(SmoothAlongChains, LeavesAStepAlone) {
  vo::Hypotheses hypotheses = vertical_edge();
  const int half = support::small_camera().height / 2;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    hypotheses.set(i, hypotheses.pixel[i].y < half ? 0.5F : 0.8F, 1e-4F);
  }
  vo::smooth_along_chains(hypotheses);
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    EXPECT_NEAR(hypotheses.smoothed[i], hypotheses.inverse_depth[i], 1e-6);
  }
}

}  // namespace
