#include "tools/studies/imperfections.h"

#include <gtest/gtest.h>

namespace {

TEST(Imperfections, AreWhatIsNotAtItsDefault) {
  tools::Scenario scenario;
  EXPECT_TRUE(tools::find_imperfections(scenario).empty());
  scenario.camera.distortion.k1 = -0.2;
  scenario.camera.distortion.k2 = 0.1;
  scenario.sensor.max_depth = 4;
  const std::vector<tools::Imperfection> found = tools::find_imperfections(scenario);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "distortion");
  EXPECT_EQ(found[0].off.size(), 2U);
  EXPECT_EQ(found[1].name, "max_depth");
}

TEST(Imperfections, AreSwitchedOffOneByOne) {
  tools::Scenario scenario;
  scenario.camera.distortion.k1 = -0.2;
  scenario.sensor.max_depth = 4;
  const std::vector<tools::Imperfection> found = tools::find_imperfections(scenario);
  const tools::Scenario straight = tools::without(scenario, {found[0]});
  EXPECT_EQ(straight.camera.distortion.k1, 0);
  EXPECT_EQ(straight.sensor.max_depth, 4);
  EXPECT_TRUE(tools::find_imperfections(tools::without(scenario, found)).empty());
}

}  // namespace
