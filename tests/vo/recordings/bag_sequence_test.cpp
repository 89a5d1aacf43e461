#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/bag_file.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/recordings/recorded_sequence.h"

namespace {

using support::bag_image;
using support::bag_of;
using support::bag_pose;
using support::BagMessage;
using support::error_text;
using support::TempFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t kSecond = 1'000'000'000;

/// Bags as the format's description has them; `bags_are_what_ros_writes` has those of ROS itself.
class BagSequence : public testing::Test {
 protected:
  static std::vector<BagMessage> six_frames() {
    std::vector<BagMessage> messages;
    for (int i = 0; i < 6; ++i) {
      messages.push_back(bag_image("/c/image_color", kSecond + i, "rgb8", 3, static_cast<char>(i)));
      messages.push_back(bag_image("/d/image", kSecond + i, "16UC1", 2, 1));
      messages.push_back(bag_pose("/pose", kSecond + i, i));
    }
    return messages;
  }

  vo::SequenceSource open(const std::string& bytes) const {
    return vo::open_recording(
        folder.write("r.bag", bytes),
        vo::RgbdCamera{vo::PinholeCamera::from_horizontal_fov(8, 6, 60), 1000});
  }

  /// Returns the offset of a bag's index, which its header states.
  static std::size_t index_of(const std::string& bag) {
    std::uint64_t index = 0;
    bag.copy(reinterpret_cast<char*>(&index), 8, bag.find("index_pos=") + 10);
    return index;
  }

  TempFolder folder;
};

TEST_F(BagSequence, ImagesDepthAndPosesAreRead) {
  const auto source = open(bag_of(six_frames()));
  EXPECT_THAT(source.notes, IsEmpty());
  ASSERT_EQ(source.timestamps.size(), 6U);
  EXPECT_EQ(source.read(4).image.at<cv::Vec3b>(0, 0), cv::Vec3b(4, 4, 4));
  EXPECT_FLOAT_EQ(source.read(4).depth(0, 0), 0.257F) << "m";
  const vo::TrajectoryFile file = vo::read_trajectory_file(folder.path() / "r.bag:/pose");
  EXPECT_EQ(file.format, vo::TrajectoryFormat::bag);
  ASSERT_EQ(file.trajectory.size(), 6U);
  EXPECT_EQ(file.trajectory[3].T_world_camera.translation().x(), 3);
}

TEST_F(BagSequence, OfACutBagWhatIsWholeIsReadWithANote) {
  const std::string bag = bag_of(six_frames());
  std::size_t most = 0;
  for (std::size_t size = 5000; size < bag.size(); size += 500) {
    try {
      const auto source = open(bag.substr(0, size));
      ASSERT_THAT(source.notes, testing::ElementsAre(testing::AnyOf(HasSubstr("is cut at byte"),
                                                                    HasSubstr("has no index"))));
      EXPECT_GE(source.timestamps.size(), most);
      most = source.timestamps.size();
    } catch (const vo::Error& error) {
      EXPECT_EQ(most, 0U) << error.what();
    }
  }
  EXPECT_EQ(most, 6U);
}

TEST_F(BagSequence, ABagThatWasNotClosedIsReadWhole) {
  std::string bag = bag_of(six_frames());
  bag.resize(index_of(bag));
  bag.replace(bag.find("index_pos=") + 10, 8, 8, '\0');
  const auto source = open(bag);
  EXPECT_EQ(source.timestamps.size(), 6U);
  EXPECT_THAT(source.notes, testing::ElementsAre(HasSubstr("has no index (it was not closed)")));
}

TEST_F(BagSequence, WhatIsDamagedIsNamed) {
  std::string bag = bag_of(six_frames());
  std::string lzo = bag;
  for (std::size_t at = lzo.find("=none"); at != std::string::npos; at = lzo.find("=none")) {
    lzo.replace(at, 5, "=lzo1");
  }
  EXPECT_THAT(error_text([&] { open(lzo); }),
              AllOf(HasSubstr("r.bag: the chunk at byte"), HasSubstr("compressed by 'lzo1'")));
  std::string huge = bag;
  huge.replace(bag.find("size=") + 5, 4, 4, '\x7F');
  EXPECT_THAT(error_text([&] { open(huge); }), HasSubstr("states 2139062143 bytes"));
  std::string other = bag;
  other.replace(bag.find("op=\x03"), 4, "op=\x05");
  EXPECT_THAT(error_text([&] { open(other); }), HasSubstr("has no header"));
  EXPECT_THAT(error_text([&] { open("#ROSBAG V1.2\n"); }),
              HasSubstr("expected an MCAP file or a ROS 1 bag (2.0)"));
}

}  // namespace
