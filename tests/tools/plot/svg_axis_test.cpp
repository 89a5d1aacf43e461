#include "tools/plot/svg_axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using testing::ElementsAre;

TEST(SvgAxis, TicksAreRoundAndInside) {
  EXPECT_THAT(tools::ticks({0, 10}, 5), ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(tools::ticks({-0.3, 0.7}, 4), ElementsAre(0, 0.5));
  EXPECT_THAT(tools::ticks({2, 2}, 4), ElementsAre(2));
  EXPECT_EQ(tools::tick_label(3 * 0.1), "0.3");
  EXPECT_EQ(tools::tick_label(-1e-18), "0");
  EXPECT_EQ(tools::tick_label(300000), "300000");
}

TEST(SvgAxis, ALogarithmicAxisSpacesRatiosEvenly) {
  const tools::AxisMap axis{{0.1, 1000}, 0, 400, tools::AxisScale::logarithmic};
  EXPECT_NEAR(axis(1), 100, 1e-9);
  EXPECT_NEAR(axis(100), 300, 1e-9);
  EXPECT_THAT(tools::axis_ticks(tools::AxisMap{{3, 60}, 0, 1, tools::AxisScale::logarithmic}, 5),
              ElementsAre(5, 10, 20, 50));
}

TEST(SvgAxis, ALogarithmicAxisHasFewTicksOnManyDecadesAndSomeOnAPartOfOne) {
  const auto log_ticks = [](const tools::Range& range) {
    return tools::axis_ticks({range, 0, 1, tools::AxisScale::logarithmic}, 3);
  };
  EXPECT_THAT(log_ticks({0.5, 2000}), ElementsAre(1, 10, 100, 1000));
  EXPECT_THAT(log_ticks({11, 19}), ElementsAre(15));
  EXPECT_THAT(log_ticks({11, 39}), ElementsAre(20, 30));
}

}  // namespace
