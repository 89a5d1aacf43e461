#include "vo/motion_files/trajectory_file.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/pose_near.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"

namespace {

using support::error_text;
using support::PoseNear;
using support::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

/// Returns the error of reading a file with this text as TUM's.
std::string error_of(const std::string& text) {
  const TempFolder folder;
  vo::write_file(folder.path() / "t.txt", text);
  const vo::TrajectoryReading as_tum{.format = vo::TrajectoryFormat::tum, .times = {}};
  return error_text([&] { vo::read_trajectory_file(folder.path() / "t.txt", as_tum); });
}

TEST(TrajectoryFile, ReadInvertsFormat) {
  const TempFolder folder;
  const vo::Trajectory trajectory = support::example_trajectory(50, 30, 1305031102.0);
  vo::write_file(folder.path() / "t.txt", vo::format_trajectory(trajectory));
  const vo::Trajectory copy = vo::read_trajectory(folder.path() / "t.txt");
  ASSERT_EQ(copy.size(), trajectory.size());
  for (std::size_t i = 0; i < copy.size(); ++i) {
    EXPECT_NEAR(copy[i].timestamp, trajectory[i].timestamp, 1e-6);
    EXPECT_THAT(copy[i].T_world_camera,
                PoseNear(trajectory[i].T_world_camera, support::PoseTolerance{1e-8, 1e-6}));
  }
}

/// A quarter turn about z takes the camera's x axis to the world's y axis; w is the last value.
TEST(TrajectoryFile, HoldsTWorldCameraWithWLast) {
  const TempFolder folder;
  vo::write_file(folder.path() / "t.txt",
                 "# comment\n\n1.5 1 2 3 0 0 0.70710678 0.70710678\r\n2,1,2,3,0,0,0,1");
  const vo::Trajectory trajectory = vo::read_trajectory(folder.path() / "t.txt");
  ASSERT_EQ(trajectory.size(), 2U);
  const Eigen::Vector3d p_world = trajectory[0].T_world_camera * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((p_world - Eigen::Vector3d(1, 3, 3)).norm(), 1e-7);
}

/// Its columns: nanoseconds, w before x, y, z, and more behind.
TEST(TrajectoryFile, ReadsEurocsStampsInNanosecondsAndWFirst) {
  const TempFolder folder;
  vo::write_file(
      folder.path() / "data.csv",
      "#timestamp, p_x [m], p_y, p_z, q_w, q_x, q_y, q_z, v_x\n"
      "1403636580838555648,4.688319,-1.786938,0.783338,0.70710678,0,0,0.70710678,-0.02\n");
  const vo::Trajectory trajectory = vo::read_trajectory(folder.path() / "data.csv");
  ASSERT_EQ(trajectory.size(), 1U);
  EXPECT_NEAR(trajectory[0].timestamp, 1403636580.838555648, 1e-6);
  const Eigen::Vector3d p_world = trajectory[0].T_world_camera * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((p_world - Eigen::Vector3d(4.688319, -0.786938, 0.783338)).norm(), 1e-7);
}

TEST(TrajectoryFile, AnErrorInEurocsFileNamesTheLine) {
  const TempFolder folder;
  vo::write_file(folder.path() / "data.csv", "#timestamp\n1403636580838555648,1,2,3\n");
  const vo::TrajectoryReading as_euroc{.format = vo::TrajectoryFormat::euroc, .times = {}};
  EXPECT_THAT(error_text([&] { vo::read_trajectory_file(folder.path() / "data.csv", as_euroc); }),
              EndsWith("data.csv:2: expected at least 8 values (timestamp px py pz qw qx qy qz), "
                       "got 4"));
}

TEST(TrajectoryFile, ErrorsNameTheLine) {
  EXPECT_THAT(error_of("1 0 0 0 0 0 0 1\n2 0 nan 0 0 0 0 1\n"),
              EndsWith("t.txt:2: expected a number, got 'nan' as value 3"));
  EXPECT_THAT(error_of("1 0 0 0 0 0 0 1\n2 0 inf 0 0 0 0 1\n"), HasSubstr("t.txt:2: "));
  EXPECT_THAT(error_of("# x\n1 0 0 0 0 0 0\n"),
              EndsWith("t.txt:2: expected 8 values (timestamp tx ty tz qx qy qz qw), got 7"));
  EXPECT_THAT(error_of("1 0 0 0 0 0 0 0\n"),
              EndsWith("t.txt:1: expected a quaternion of length 1, got length 0"));
  EXPECT_THAT(error_of("# nothing\n"), EndsWith("t.txt: holds no poses"));
}

TEST(TrajectoryFile, PosesThatAreATenthOfAMicrosecondApartAreReadAsTheyWere) {
  const TempFolder folder;
  vo::Trajectory trajectory = support::example_trajectory(3, 30, 1305031102.0);
  trajectory[1].timestamp = trajectory[0].timestamp + 1e-6;
  trajectory[2].timestamp = trajectory[1].timestamp + 3e-7;
  vo::write_file(folder.path() / "t.txt", vo::format_trajectory(trajectory));
  const vo::Trajectory copy = vo::read_trajectory(folder.path() / "t.txt");
  ASSERT_EQ(copy.size(), 3U);
  for (std::size_t i = 0; i < copy.size(); ++i) {
    EXPECT_EQ(copy[i].timestamp, trajectory[i].timestamp);
  }
}

TEST(TrajectoryFile, NoNumberCutsALine) {
  const vo::Trajectory trajectory = {
      {1e300, vo::SE3(Eigen::Quaterniond::Identity(), {1e300, -1e300, 1e300})},
      {1.1e300, vo::SE3()}};
  const std::string text = vo::format_trajectory(trajectory);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_THAT(text, testing::ContainsRegex(" 0\\.0+ 0\\.0+ 0\\.0+ 1\\.0+\n"));
}

TEST(TrajectoryFile, RefusesStampsThatNanosecondsCannotHold) {
  EXPECT_THAT(error_of("9.1e9 0 0 0 0 0 0 1\n"),
              EndsWith("t.txt:1: expected a stamp within 9e+09 s of 0, got 9.1e+09 s"));
  EXPECT_THAT(error_of("-1e300 0 0 0 0 0 0 1\n"), HasSubstr("t.txt:1: expected a stamp within"));
}

}  // namespace
