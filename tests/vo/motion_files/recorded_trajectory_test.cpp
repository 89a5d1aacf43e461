#include "vo/motion_files/recorded_trajectory.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/recordings.h"
#include "tests/support/temp_folder.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using support::error_text;
using support::mcap_of;
using support::pose_at_x;
using support::pose_message;
using support::TempFolder;
using support::TestMessage;
using support::tf_message;
using testing::AllOf;
using testing::HasSubstr;

constexpr std::int64_t kSecond = 1'000'000'000;

class RecordedTrajectory : public testing::Test {
 protected:
  vo::TrajectoryFile read(const std::vector<TestMessage>& messages,
                          const std::string& topic = "") const {
    const std::string path = folder.write("r.mcap", mcap_of(messages)).string();
    return vo::read_trajectory_file(topic.empty() ? path : path + ":" + topic);
  }

  static double x_of(const vo::StampedPose& pose) { return pose.T_world_camera.translation().x(); }

  TempFolder folder;
};

TEST_F(RecordedTrajectory, PosesAreReadWithTheirStamps) {
  const auto file = read({pose_message("/pose", pose_at_x(kSecond, 1)),
                          pose_message("/pose", pose_at_x(3 * kSecond / 2, 2))});
  EXPECT_EQ(file.format, vo::TrajectoryFormat::mcap);
  ASSERT_EQ(file.trajectory.size(), 2U);
  EXPECT_EQ(file.trajectory[1].timestamp, 1.5);
  EXPECT_EQ(x_of(file.trajectory[1]), 2);
  EXPECT_THAT(file.notes, testing::IsEmpty());
}

TEST_F(RecordedTrajectory, OfSeveralTopicsOneIsNamed) {
  const std::vector<TestMessage> messages = {
      pose_message("/a", pose_at_x(kSecond, 1)), pose_message("/b", pose_at_x(kSecond, 2)),
      tf_message({pose_at_x(kSecond, 3)}), tf_message({pose_at_x(2 * kSecond, 4)})};
  EXPECT_EQ(x_of(read(messages, "/b").trajectory[0]), 2);
  EXPECT_EQ(x_of(read(messages, "/tf").trajectory.at(0)), 3);
  EXPECT_THAT(error_text([&] { read(messages); }),
              AllOf(HasSubstr("several topics of poses"),
                    HasSubstr("/a (geometry_msgs/PoseStamped), /b (geometry_msgs/PoseStamped)"),
                    HasSubstr("r.mcap:TOPIC")));
  EXPECT_THAT(error_text([&] { read(messages, "/c"); }),
              AllOf(HasSubstr("has no poses of /c"), HasSubstr("/tf (tf2_msgs/TFMessage)")));
  EXPECT_THAT(error_text([&] { read(messages, "/b:world.camera"); }), HasSubstr("/tf alone"));
  EXPECT_THAT(error_text([&] {
                read({{"/scan", "sensor_msgs/msg/LaserScan", 1, "x"}}, "/scan");
              }),
              HasSubstr("/scan is a sensor_msgs/LaserScan, expected poses, of one of: none"));
}

TEST_F(RecordedTrajectory, FramesOfTfAreChained) {
  std::vector<TestMessage> messages = {
      tf_message({pose_at_x(0, 0.1, "base", "camera.left")}, "/tf_static")};
  for (const int i : {0, 1, 2, 3}) {
    messages.push_back(tf_message({pose_at_x(i * kSecond, i, "odom", "base")}));
  }
  messages.push_back(tf_message({pose_at_x(kSecond / 2, 10, "map", "odom")}));
  messages.push_back(tf_message({pose_at_x(5 * kSecond / 2, 30, "map", "odom")}));
  const auto odometry = read(messages, "/tf:odom.camera.left").trajectory;
  ASSERT_EQ(odometry.size(), 4U);
  EXPECT_DOUBLE_EQ(x_of(odometry[2]), 2.1);
  const auto mapped = read(messages, "/tf:map.base").trajectory;
  ASSERT_EQ(mapped.size(), 2U) << "stamps between those of map.odom";
  EXPECT_EQ(mapped[0].timestamp, 1);
  EXPECT_DOUBLE_EQ(x_of(mapped[0]), 15 + 1) << "m, interpolated";
  EXPECT_THAT(error_text([&] { read(messages); }),
              AllOf(HasSubstr("map.odom"), HasSubstr("odom.base"), HasSubstr(":/tf:PARENT.CHILD")));
  EXPECT_THAT(error_text([&] { read(messages, "/tf:base.map"); }),
              HasSubstr("base is not above map"));
  EXPECT_THAT(
      error_text([&] { read(messages, "/tf:base.head"); }),
      HasSubstr("expected PARENT.CHILD of two of its frames (base, camera.left, map, odom)"));
}

TEST_F(RecordedTrajectory, FramesInACircleEnd) {
  const std::vector<TestMessage> messages = {tf_message({pose_at_x(0, 1, "a", "b")}),
                                             tf_message({pose_at_x(0, 1, "b", "a")})};
  EXPECT_THAT(error_text([&] { read(messages, "/tf:c.a"); }), HasSubstr("expected PARENT.CHILD"));
}

TEST_F(RecordedTrajectory, MistakesAreNamedWithTheirPlace) {
  vo::RosPose bad = pose_at_x(kSecond, 1);
  bad.rotation = {0, 0, 0, 0.5};
  EXPECT_THAT(error_text([&] { read({pose_message("/pose", bad)}); }),
              AllOf(HasSubstr("/pose, message of 1.000000 s"), HasSubstr("length 0.5")));
  TestMessage cut = pose_message("/pose", pose_at_x(kSecond, 1));
  cut.data.resize(cut.data.size() - 8);
  EXPECT_THAT(error_text([&] { read({cut}); }), HasSubstr("ends early"));
  cut.data[1] = 0;
  EXPECT_THAT(error_text([&] { read({cut}); }), HasSubstr("CDR of another kind"));
  EXPECT_THAT(error_text([&] {
                read({pose_message("/pose", pose_at_x(9 * kSecond, 1)),
                      pose_message("/pose", pose_at_x(kSecond, 1))});
              }),
              HasSubstr("expected a stamp after the ones before it"));
  EXPECT_THAT(error_text([&] {
                vo::read_trajectory_file(
                    folder.write("r.mcap", mcap_of({pose_message("/p", pose_at_x(kSecond, 1))})),
                    {.format = vo::TrajectoryFormat::bag, .times = {}});
              }),
              HasSubstr("is a mcap recording, expected bag"));
}

TEST_F(RecordedTrajectory, APathWithAColonIsAFileWhereThereIsOne) {
  folder.write("a.mcap", "");
  const auto path = folder.write("a.mcap:b", "1 0 0 0 0 0 0 1\n");
  EXPECT_EQ(vo::read_trajectory(path).size(), 1U);
  EXPECT_EQ(vo::recording_name(folder.path() / "a.mcap:/tf:x.y").topic, "/tf:x.y");
}

}  // namespace
