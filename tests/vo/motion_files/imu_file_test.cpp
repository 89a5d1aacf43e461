#include "vo/motion_files/imu_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/temp_folder.h"

namespace {

using support::TempFolder;
using testing::HasSubstr;

TEST(ImuFile, ReadsBackAsEurocHasIt) {
  const TempFolder folder;
  const std::vector<vo::ImuSample> samples = {
      {1.403636579763555555, {0.1, -0.2, 1 / 3.0}, {9, 1, 2}},
      {1.408636579763555555, {0, 0, 0}, {1e-9, 0, -9.81}}};
  const std::string text = vo::format_imu(samples);
  EXPECT_THAT(text, HasSubstr("\n1403636580,0.1,-0.2,0.333333333333,9,1,2\n"));
  const auto copy = vo::read_imu(folder.write("data.csv", text));
  ASSERT_EQ(copy.size(), 2U);
  EXPECT_NEAR(copy[0].timestamp, samples[0].timestamp, 1e-9);
  EXPECT_LT((copy[0].angular_velocity - samples[0].angular_velocity).norm(), 1e-11);
  EXPECT_LT((copy[1].specific_force - samples[1].specific_force).norm(), 1e-11);
}

TEST(ImuFile, StatesReadBackWithTheScalarOfTheQuaternionFirst) {
  const TempFolder folder;
  const vo::BodyState state{0.25, support::example_pose(0.7), {1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const std::string text = vo::format_states({state});
  const double w = state.T_world_body.rotation().w();
  EXPECT_THAT(text, HasSubstr("\n250000000,"));
  EXPECT_THAT(text, HasSubstr(std::to_string(w).substr(0, 6)));
  const auto copy = vo::read_states(folder.write("data.csv", text));
  ASSERT_EQ(copy.size(), 1U);
  EXPECT_LT((copy[0].T_world_body.inverse() * state.T_world_body).log().norm(), 1e-11);
  EXPECT_LT((copy[0].velocity - state.velocity).norm(), 1e-11);
  EXPECT_LT((copy[0].accel_bias - state.accel_bias).norm(), 1e-11);
}

TEST(ImuFile, AnErrorNamesFileAndLine) {
  const TempFolder folder;
  const auto path = folder.write("data.csv", "#header\n1,2,3,4,5,6,7\n1,2,3\n");
  EXPECT_THAT(support::error_text([&] { vo::read_imu(path); }),
              HasSubstr("data.csv:3: expected 7 values, got 3"));
}

}  // namespace
