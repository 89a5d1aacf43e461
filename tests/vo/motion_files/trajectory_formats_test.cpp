#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/pose_near.h"
#include "tests/support/temp_folder.h"
#include "vo/core/error.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using support::error_text;
using support::PoseNear;
using support::TempFolder;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using vo::TrajectoryFormat;

constexpr support::PoseTolerance kRounding{.translation_m = 1e-8, .rotation_deg = 1e-6};
constexpr const char* kStill = " 0 0 0 0 0 0 1\n";  // a pose of TUM's behind its stamp

void expect_same(const vo::Trajectory& copy, const vo::Trajectory& truth) {
  ASSERT_EQ(copy.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_NEAR(copy[i].timestamp, truth[i].timestamp, 1e-6) << "pose " << i;
    EXPECT_THAT(copy[i].T_world_camera, PoseNear(truth[i].T_world_camera, kRounding));
  }
}

/// A trajectory as COLMAP's images.txt has it, the last image first.
std::string as_colmap(const vo::Trajectory& truth, const std::vector<std::string>& names) {
  std::string text =
      "# Image list with two lines of data per image:\n"
      "#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
      "#   POINTS2D[] as (X, Y, POINT3D_ID)\n";
  for (std::size_t i = truth.size(); i-- > 0;) {
    const vo::SE3 T_camera_world = truth[i].T_world_camera.inverse();
    const Eigen::Quaterniond& q = T_camera_world.rotation();
    const Eigen::Vector3d& t = T_camera_world.translation();
    std::ostringstream line;
    line.precision(17);
    line << i + 1 << " " << q.w() << " " << q.x() << " " << q.y() << " " << q.z() << " " << t.x()
         << " " << t.y() << " " << t.z() << " 1 " << names.at(i) << "\n"
         << (i % 2 == 0 ? "12.5 21.25 101 18.0 27.75 -1\n" : "\n");
    text += line.str();
  }
  return text;
}

class TrajectoryFormats : public testing::Test {
 protected:
  vo::TrajectoryFile read(const std::string& text, const vo::TrajectoryReading& reading = {}) {
    return vo::read_trajectory_file(folder.write("t.txt", text), reading);
  }

  std::string error_of(const std::string& text, const vo::TrajectoryReading& reading = {}) {
    return error_text([&] { read(text, reading); });
  }

  TempFolder folder;
  vo::Trajectory truth = support::example_trajectory(5, 10, 1305031102.0);
};

TEST_F(TrajectoryFormats, EachIsRecognisedByItsContentAndReadsBack) {
  const auto times = folder.write("times.txt", vo::format_kitti_times(truth));
  const std::vector<std::pair<TrajectoryFormat, std::string>> files = {
      {TrajectoryFormat::tum, vo::format_trajectory(truth)},
      {TrajectoryFormat::euroc, vo::format_euroc_trajectory(truth)},
      {TrajectoryFormat::kitti, vo::format_kitti_poses(truth)}};
  for (const auto& [format, text] : files) {
    const vo::TrajectoryFile file = read(text, {.format = {}, .times = times});
    EXPECT_EQ(file.format, format);
    EXPECT_TRUE(file.notes.empty());
    expect_same(file.trajectory, truth);
  }
}

TEST_F(TrajectoryFormats, EurocsStampsFromZeroAreRecognisedToo) {
  const vo::Trajectory from_zero = support::example_trajectory(3, 10);
  const vo::TrajectoryFile file = read(vo::format_euroc_trajectory(from_zero));
  EXPECT_EQ(file.format, TrajectoryFormat::euroc);
  expect_same(file.trajectory, from_zero);
}

TEST_F(TrajectoryFormats, OrbSlamsStampsInNanosecondsAreRecognised) {
  const vo::TrajectoryFile file =
      read("1403636579763555584.000000 1 2 3 0 0 0.7071068 0.7071068\n");
  EXPECT_EQ(file.format, TrajectoryFormat::orb_slam);
  EXPECT_NEAR(file.trajectory.at(0).timestamp, 1403636579.763555584, 1e-6);
  const Eigen::Vector3d p_world = file.trajectory[0].T_world_camera * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((p_world - Eigen::Vector3d(1, 3, 3)).norm(), 1e-6) << "w is the last value";
}

TEST_F(TrajectoryFormats, AFormatThatIsGivenCountsMoreThanTheContent) {
  const std::string text = std::string("100000000") + kStill + "200000000" + kStill;
  EXPECT_EQ(read(text).trajectory.at(1).timestamp, 2e8);
  EXPECT_DOUBLE_EQ(
      read(text, {.format = TrajectoryFormat::orb_slam, .times = {}}).trajectory.at(1).timestamp,
      0.2);
  EXPECT_THAT(error_of(text, {.format = TrajectoryFormat::kitti, .times = {}}),
              EndsWith("t.txt:1: expected 12 values (the upper three rows of a pose's matrix), "
                       "got 8"));
}

TEST_F(TrajectoryFormats, EurocsStampsAreWholeAndHaveACommaBehindThem) {
  const vo::TrajectoryReading euroc{.format = TrajectoryFormat::euroc, .times = {}};
  EXPECT_EQ(read("100000000,0,0,0,1,0,0,0\n", euroc).trajectory.size(), 1U);
  for (const std::string line :
       {"1305031102.175304 0 0 0 0 0 0 1", "100000000 0 0 0 1 0 0 0", "1e9,0,0,0,1,0,0,0"}) {
    EXPECT_THAT(error_of("# head\n" + line + "\n", euroc),
                HasSubstr("t.txt:2: expected a stamp in whole nanoseconds and a comma"));
  }
}

TEST_F(TrajectoryFormats, WhatIsOfNoFormatIsAnErrorThatNamesThemAll) {
  EXPECT_THAT(error_of("# x\n1 0 0 0 0 0 0\n"),
              HasSubstr("t.txt:2: expected the 8 values of a pose"));
  EXPECT_THAT(error_of("# x\n1 0 0 0 0 0 0\n"), EndsWith("(COLMAP's images.txt), got 7"));
  EXPECT_THAT(error_of("# x\n"), EndsWith("t.txt: holds no poses"));
  EXPECT_THAT(error_of("#ROSBAG V2.0\n"), EndsWith("t.txt: has no header"));
}

/// TUM's fr2/desk has one such line among 20 960.
TEST_F(TrajectoryFormats, OfPosesWithOneStampTheFirstCounts) {
  const vo::TrajectoryFile file =
      read("1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n2 9 0 0 0 0 0 1\n2 8 0 0 0 0 0 1\n3 3 0 0 0 0 0 1\n");
  ASSERT_EQ(file.trajectory.size(), 3U);
  EXPECT_EQ(file.trajectory[1].T_world_camera.translation().x(), 2);
  EXPECT_THAT(file.notes,
              ElementsAre(EndsWith("t.txt: 2 of 5 poses have the stamp of another; the first of "
                                   "each stamp counts")));
}

TEST_F(TrajectoryFormats, StampsThatGoBackALittleAreSorted) {
  const vo::TrajectoryFile file =
      read("1 1 0 0 0 0 0 1\n1.2 3 0 0 0 0 0 1\n1.1 2 0 0 0 0 0 1\n1.3 4 0 0 0 0 0 1\n");
  ASSERT_EQ(file.trajectory.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(file.trajectory[i].T_world_camera.translation().x(), static_cast<double>(i + 1));
  }
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("t.txt: 1 of 4 poses came after later ones")));
}

TEST_F(TrajectoryFormats, StampsThatGoBackALotAreAnError) {
  EXPECT_THAT(error_of(std::string("1") + kStill + "3" + kStill + "2.4" + kStill),
              EndsWith("t.txt:3: expected a stamp after the ones before it, or up to 0.5 s "
                       "earlier, got one that is 0.6 s earlier"));
  EXPECT_EQ(read(std::string("1") + kStill + "3" + kStill + "2.5" + kStill).trajectory.size(), 3U);
}

TEST_F(TrajectoryFormats, KittisPosesWithoutTimesAreATenthOfASecondApart) {
  const vo::TrajectoryFile file = read(vo::format_kitti_poses(truth));
  ASSERT_EQ(file.trajectory.size(), truth.size());
  EXPECT_NEAR(file.trajectory[4].timestamp, 0.4, 1e-12);
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("KITTI's poses have no stamps")));
}

TEST_F(TrajectoryFormats, KittisPosesAndTimesAreEquallyMany) {
  const std::string poses = vo::format_kitti_poses(truth);
  const auto few = folder.write("few.txt", "0\n0.1\n");
  const auto many = folder.write("many.txt", "0\n0.1\n0.2\n0.3\n0.4\n0.5\n");
  EXPECT_THAT(error_of(poses, {.format = {}, .times = few}),
              HasSubstr("t.txt:3: is pose 3, expected as many as the 2 stamps of "));
  EXPECT_THAT(error_of(poses, {.format = {}, .times = many}),
              HasSubstr("t.txt: holds 5 poses, expected as many as the 6 stamps of "));
}

TEST_F(TrajectoryFormats, KittisMatrixMustBeARotation) {
  EXPECT_THAT(error_of("1 0 0 0 0 1 0 0 0 0 -1 0\n"),
              EndsWith("t.txt:1: expected a rotation in the first three columns"));
  EXPECT_THAT(error_of("2 0 0 0 0 2 0 0 0 0 2 0\n"), HasSubstr("expected a rotation"));
  EXPECT_THAT(error_of("1 0 0 1e10 0 1 0 0 0 0 1 0\n"), HasSubstr("expected a position within"));
}

TEST_F(TrajectoryFormats, ColmapsNamesCarryStampsInSecondsOrNanoseconds) {
  const std::vector<std::string> names = {"rgb/1305031102.000000.png", "a b-1305031102.1.jpg",
                                          "cam0/1305031102200000000.png", "1305031102.300000.png",
                                          "x1305031102.400000.png"};
  const vo::TrajectoryFile file = read(as_colmap(truth, names));
  EXPECT_EQ(file.format, TrajectoryFormat::colmap);
  EXPECT_TRUE(file.notes.empty()) << "the order of images means nothing";
  expect_same(file.trajectory, truth);
}

TEST_F(TrajectoryFormats, ColmapsNamesAreLookedUpInAListOfImages) {
  const std::vector<std::string> names = {"0.png", "1.png", "2.png", "3.png", "4.png"};
  std::string tum = "# colour images\n";
  std::string kitti;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    tum += vo::concat("1305031102.", i, " rgb/", names[i], "\n");
    kitti += vo::concat("1305031102.", i, "\n");
  }
  const auto list = folder.write("rgb.txt", tum);
  expect_same(read(as_colmap(truth, names), {.format = {}, .times = list}).trajectory, truth);
  const auto stamps = folder.write("times.txt", kitti);
  expect_same(read(as_colmap(truth, names), {.format = {}, .times = stamps}).trajectory, truth);
  const auto ns = folder.write("data.csv", "#timestamp [ns],filename\n200000000,200000000.png\n");
  const vo::Trajectory one = {truth[0]};
  EXPECT_NEAR(read(as_colmap(one, {"200000000.png"}), {.format = {}, .times = ns})
                  .trajectory.at(0)
                  .timestamp,
              0.2, 1e-12);
}

TEST_F(TrajectoryFormats, ColmapsErrorsNameTheImage) {
  const vo::Trajectory one = {truth[0]};
  EXPECT_THAT(error_of(as_colmap(one, {"frame_000012.png"})),
              HasSubstr("t.txt:4: expected a name that ends with a stamp"));
  const auto stamps = folder.write("times.txt", "0\n0.1\n");
  EXPECT_THAT(error_of(as_colmap(one, {"frame_12.png"}), {.format = {}, .times = stamps}),
              HasSubstr("t.txt:4: is frame 12 (from 0), expected one of the 2 of "));
  const auto list = folder.write("rgb.txt", "0 rgb/0.png\n");
  EXPECT_THAT(error_of(as_colmap(one, {"7.png"}), {.format = {}, .times = list}),
              HasSubstr("rgb.txt lists, got 7.png"));
  EXPECT_THAT(error_of("1 1 0 0 0 0 0 0 1 1.5.png\n2 1 0 0 0 0 0 0 1 2.5.png\n"),
              HasSubstr("t.txt:2: expected the points of the image before it"));
  EXPECT_THAT(error_of("1 2 0 0 0 0 0 0 1 1.5.png\n\n"), HasSubstr("a quaternion of length 1"));
}

TEST_F(TrajectoryFormats, AListOfStampsIsOneOrTheOther) {
  const auto mixed = folder.write("mixed.txt", "0 rgb/0.png\n0.1\n");
  EXPECT_THAT(error_of(vo::format_kitti_poses(truth), {.format = {}, .times = mixed}),
              HasSubstr("mixed.txt:2: expected a stamp and a file"));
  const auto twice = folder.write("twice.txt", "0 rgb/0.png\n0.1 depth/0.png\n");
  EXPECT_THAT(error_of(vo::format_kitti_poses(truth), {.format = {}, .times = twice}),
              HasSubstr("twice.txt:2: expected files of different names, got 0.png again"));
}

}  // namespace
