#include "vo/recordings/recorded_sequence.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/recordings.h"
#include "tests/support/sequence_layouts.h"
#include "tests/support/temp_folder.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/files/input.h"
#include "vo/recordings/camera_message.h"
#include "vo/recordings/mcap_sequence.h"

namespace {

namespace fs = std::filesystem;
using support::error_text;
using support::image_message;
using support::mcap_of;
using support::TempFolder;
using support::TestMessage;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::int64_t kFrameNs = 33'333'333;

/// Sequences in recordings of ROS 2.
class RecordedSequence : public testing::Test {
 protected:
  vo::SequenceSource open(const std::string& bytes,
                          const vo::RecordingRequest& request = {}) const {
    return vo::open_recording(folder.write("r.mcap", bytes), tiny_camera(), request);
  }

  static vo::RgbdCamera tiny_camera() {
    return {vo::PinholeCamera::from_horizontal_fov(8, 6, 60), 1000};
  }

  static cv::Mat grey(int value) { return cv::Mat(6, 8, CV_8UC1, cv::Scalar::all(value)); }
  static cv::Mat colour() { return cv::Mat(6, 8, CV_8UC3, cv::Scalar(1, 2, 3)); }
  static cv::Mat depth() { return cv::Mat(6, 8, CV_16UC1, cv::Scalar::all(1500)); }

  static std::string written(const vo::SequenceSource& source, const fs::path& path,
                             const vo::McapLayout& layout = {}) {
    vo::write_mcap_sequence(path, source, layout, vo::PointClouds::none, {},
                            [](std::size_t, std::size_t) {});
    return vo::read_file(path);
  }

  static void expect_same(const vo::SequenceSource& copy, const vo::SequenceSource& source) {
    ASSERT_EQ(copy.timestamps.size(), source.timestamps.size());
    for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
      const vo::RgbdFrame frame = copy.read(i);
      EXPECT_NEAR(copy.timestamps[i], source.timestamps[i], 0.51e-9);
      EXPECT_EQ(frame.timestamp, copy.timestamps[i]);
      EXPECT_EQ(cv::norm(frame.image, source.read(i).image, cv::NORM_INF), 0);
      EXPECT_EQ(cv::norm(frame.depth, source.read(i).depth, cv::NORM_INF), 0);
    }
  }

  TempFolder folder;
};

TEST_F(RecordedSequence, WhatIsWrittenReadsBackExactly) {
  const vo::SequenceSource source = support::rendered_sequence(5);
  for (const auto compression :
       {vo::Compression::none, vo::Compression::lz4, vo::Compression::zstd}) {
    const fs::path path = folder.path() / (std::string(vo::to_string(compression)) + ".mcap");
    written(source, path, {.compression = compression, .chunk_bytes = 100'000});
    const vo::SequenceSource copy = vo::open_recording(path, std::nullopt);
    EXPECT_THAT(copy.notes, IsEmpty());
    EXPECT_EQ(copy.camera.pinhole.fx, source.camera.pinhole.fx);
    EXPECT_EQ(copy.camera.pinhole.cy, source.camera.pinhole.cy);
    EXPECT_EQ(copy.camera.depth_units_per_m, 1000);
    expect_same(copy, source);
    ASSERT_EQ(copy.truth.size(), source.truth.size());
    for (std::size_t i = 0; i < source.truth.size(); ++i) {
      EXPECT_EQ(copy.truth[i].T_world_camera.translation(),
                source.truth[i].T_world_camera.translation());
    }
  }
}

TEST_F(RecordedSequence, EqualSequencesGiveEqualBytes) {
  const vo::SequenceSource source = support::rendered_sequence(3);
  EXPECT_EQ(written(source, folder.path() / "a.mcap"), written(source, folder.path() / "b.mcap"));
}

TEST_F(RecordedSequence, DepthOfSixteenBitsIsWrittenSoWhereItIsInMillimetres) {
  vo::SequenceSource source = support::rendered_sequence(2);
  const auto depth_of = [&](double units_per_m) {
    source.read = [=, render = source.read](std::size_t index) {
      vo::RgbdFrame frame = render(index);
      frame.depth = vo::from_depth_units(vo::to_depth_units(frame.depth, units_per_m), units_per_m);
      return frame;
    };
    const std::string name = std::to_string(static_cast<int>(units_per_m)) + ".mcap";
    const std::string bytes =
        written(source, folder.path() / name, {.compression = vo::Compression::none});
    expect_same(vo::open_recording(folder.path() / name, std::nullopt), source);
    return bytes;
  };
  EXPECT_THAT(depth_of(5000), AllOf(HasSubstr("32FC1"), testing::Not(HasSubstr("16UC1"))));
  source = support::rendered_sequence(2);
  EXPECT_THAT(depth_of(1000), AllOf(HasSubstr("16UC1"), testing::Not(HasSubstr("32FC1"))));
}

TEST_F(RecordedSequence, OfACutFileWhatIsWholeIsReadWithANote) {
  const vo::SequenceSource source = support::rendered_sequence(5);
  const std::string bytes = written(source, folder.path() / "whole.mcap", {.chunk_bytes = 100'000});
  constexpr std::size_t kHead = 8;  // bytes by which the file is known to be one
  std::size_t most = 0;
  for (std::size_t size = 1; size < bytes.size(); size += bytes.size() / 23) {
    const fs::path path = folder.write("cut.mcap", bytes.substr(0, size));
    try {
      const vo::SequenceSource cut = vo::open_recording(path, std::nullopt);
      ASSERT_THAT(cut.notes, testing::Contains(HasSubstr("is cut at byte"))) << size;
      ASSERT_LE(cut.timestamps.size(), source.timestamps.size());
      EXPECT_EQ(cv::norm(cut.read(0).image, source.read(0).image, cv::NORM_INF), 0);
      EXPECT_GE(cut.timestamps.size(), most) << "more bytes hold no fewer frames";
      most = cut.timestamps.size();
    } catch (const vo::Error& error) {
      EXPECT_EQ(most, 0U) << error.what();
      EXPECT_THAT(error.what(), HasSubstr("cut.mcap")) << size;
      if (size > kHead) {
        EXPECT_THAT(error.what(), HasSubstr("is cut at byte")) << size;
      }
    }
  }
  EXPECT_GE(most, 4U);
}

TEST_F(RecordedSequence, ADamagedSummaryIsDoneWithout) {
  const vo::SequenceSource source = support::rendered_sequence(3);
  std::string bytes = written(source, folder.path() / "whole.mcap");
  bytes[bytes.size() - 100] = static_cast<char>(~bytes[bytes.size() - 100]);
  const vo::SequenceSource copy = vo::open_recording(folder.write("r.mcap", bytes), std::nullopt);
  EXPECT_THAT(copy.notes, testing::ElementsAre(HasSubstr("its summary cannot be used")));
  expect_same(copy, source);
}

TEST_F(RecordedSequence, ADamagedChunkIsNamed) {
  const vo::SequenceSource source = support::rendered_sequence(3);
  std::string bytes =
      written(source, folder.path() / "whole.mcap", {.compression = vo::Compression::lz4});
  bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
  EXPECT_THAT(error_text([&] { vo::open_recording(folder.write("r.mcap", bytes), std::nullopt); }),
              AllOf(HasSubstr("r.mcap: the chunk at byte"), HasSubstr("damaged")));
}

TEST_F(RecordedSequence, ACompressionThatIsNotKnownIsNamed) {
  std::string bytes = mcap_of({image_message("/c/image_raw", 1, "mono8", grey(1))});
  for (std::size_t at = bytes.find("zstd"); at != std::string::npos; at = bytes.find("zstd")) {
    bytes.replace(at, 4, "zpaq");
  }
  EXPECT_THAT(error_text([&] { open(bytes); }), HasSubstr("is compressed by 'zpaq'"));
}

TEST_F(RecordedSequence, SizesBeyondTheFileAreErrorsBeforeMemoryIsAskedFor) {
  std::string bytes = mcap_of({image_message("/c/image_raw", 1, "mono8", grey(1))});
  bytes[bytes.find("zstd") - 12] = 1;  // the chunk states 4 GB
  EXPECT_THAT(error_text([&] { open(bytes); }), HasSubstr("expected at most 1000000000"));
  TestMessage huge = image_message("/c/image_raw", 1, "mono8", grey(1));
  const std::size_t width = huge.data.find("mono8") - 8;
  huge.data[width] = static_cast<char>(0xFF);
  huge.data[width + 1] = 0x3F;  // 16383 px
  EXPECT_THAT(error_text([&] { open(mcap_of({huge})); }), HasSubstr("rows of"));
  huge.data[width + 3] = 0x7F;
  EXPECT_THAT(error_text([&] { open(mcap_of({huge})); }), HasSubstr("expected an image of 1 to"));
}

TEST_F(RecordedSequence, EachEncodingGivesThePixels) {
  const cv::Mat rgba(6, 8, CV_8UC4, cv::Scalar(3, 2, 1, 9));
  const cv::Mat bgra(6, 8, CV_8UC4, cv::Scalar(1, 2, 3, 9));
  const cv::Mat rgb(6, 8, CV_8UC3, cv::Scalar(3, 2, 1));
  const std::vector<std::pair<const char*, cv::Mat>> encodings = {
      {"bgr8", colour()}, {"rgb8", rgb}, {"rgba8", rgba}, {"bgra8", bgra}};
  for (const auto& [encoding, pixels] : encodings) {
    const auto source = open(mcap_of({image_message("/c/image_raw", 1, encoding, pixels)}));
    EXPECT_EQ(cv::norm(source.read(0).image, colour(), cv::NORM_INF), 0) << encoding;
    EXPECT_TRUE(source.read(0).depth.empty());
  }
  const auto mono = open(mcap_of({image_message("/c/image_raw", 1, "mono8", grey(7))}));
  EXPECT_EQ(cv::norm(mono.read(0).image, grey(7), cv::NORM_INF), 0);
  const cv::Mat metres(6, 8, CV_32FC1, cv::Scalar::all(1.5));
  for (const auto& [encoding, pixels] :
       {std::pair{"16UC1", depth()}, {"mono16", depth()}, {"32FC1", metres}}) {
    const auto source = open(mcap_of({image_message("/c/image_raw", 1, "mono8", grey(7)),
                                      image_message("/d/image_raw", 1, encoding, pixels)}));
    EXPECT_LE(cv::norm(source.read(0).depth, metres, cv::NORM_INF), 2e-7) << encoding;
  }
  EXPECT_THAT(error_text([&] {
                open(mcap_of({image_message("/c/image_raw", 1, "bayer_rggb8", grey(7))}));
              }),
              HasSubstr("/c/image_raw (sensor_msgs/Image, bayer_rggb8)"));
}

TEST_F(RecordedSequence, WhatIsNotFiniteIsNoDepth) {
  cv::Mat metres(6, 8, CV_32FC1, cv::Scalar::all(std::numeric_limits<float>::quiet_NaN()));
  metres.at<float>(0, 0) = 2;
  metres.at<float>(0, 1) = -1;
  const auto source = open(mcap_of({image_message("/c/image_raw", 1, "mono8", grey(7)),
                                    image_message("/d/image_raw", 1, "32FC1", metres)}));
  EXPECT_EQ(cv::countNonZero(source.read(0).depth), 1);
}

TEST_F(RecordedSequence, OfSeveralCamerasOneIsChosenByItsTopic) {
  const std::string bytes = mcap_of({image_message("/left/image_raw", 1, "mono8", grey(1)),
                                     image_message("/right/image_raw", 1, "mono8", grey(2)),
                                     image_message("/d/image_raw", 1, "16UC1", depth())});
  EXPECT_THAT(error_text([&] { open(bytes); }),
              AllOf(HasSubstr("/left/image_raw, /right/image_raw"), HasSubstr("--rgb-topic")));
  const auto source = open(bytes, {.topics = {.image = "/right/image_raw"}});
  EXPECT_EQ(source.read(0).image.at<uchar>(0, 0), 2);
  EXPECT_THAT(error_text([&] { open(bytes, {.topics = {.image = "/up/image_raw"}}); }),
              AllOf(HasSubstr("--rgb-topic /up/image_raw"),
                    HasSubstr("/left/image_raw (sensor_msgs/Image, mono8, 8x6)")));
}

TEST_F(RecordedSequence, DepthIsThatOfTheImageAndItsFrame) {
  const cv::Mat half(3, 4, CV_16UC1, cv::Scalar::all(1));
  const cv::Mat other(6, 8, CV_16UC1, cv::Scalar::all(2));
  const std::string bytes =
      mcap_of({image_message("/color/image_raw", 1, "bgr8", colour(), "color"),
               image_message("/infra1/image_rect_raw", 1, "mono8", grey(1), "infra"),
               image_message("/depth/image_rect_raw", 1, "16UC1", other, "depth"),
               image_message("/small/image_raw", 1, "16UC1", half, "color"),
               image_message("/aligned/image_raw", 1, "16UC1", depth(), "color")});
  EXPECT_FLOAT_EQ(open(bytes).read(0).depth(0, 0), 1.5F) << "m";
  EXPECT_FLOAT_EQ(open(bytes, {.topics = {.depth = "/depth/image_rect_raw"}}).read(0).depth(0, 0),
                  0.002F);
  EXPECT_THAT(error_text([&] { open(bytes, {.topics = {.depth = "/small/image_raw"}}); }),
              HasSubstr("/small/image_raw is of 4x3 px, expected the camera's 8x6"));
}

TEST_F(RecordedSequence, DepthBesideTheImageIsDelayed) {
  const std::int64_t at = 10 * kFrameNs;
  const std::string bytes =
      mcap_of({image_message("/color/image_raw", at, "bgr8", colour(), "color"),
               image_message("/aligned/image_raw", at - 8'000'000, "16UC1", depth(), "color")});
  EXPECT_NEAR(open(bytes).read(0).depth_delay, -0.008, 1e-9);
}

TEST_F(RecordedSequence, StampsOutOfOrderAreSortedOrErrors) {
  std::vector<TestMessage> messages;
  for (const int frame : {0, 2, 1, 2, 3}) {
    messages.push_back(image_message("/c/image_raw", 1 + frame * kFrameNs, "mono8", grey(frame)));
  }
  const auto source = open(mcap_of(messages));
  ASSERT_EQ(source.timestamps.size(), 4U);
  EXPECT_EQ(source.read(2).image.at<uchar>(0, 0), 2);
  EXPECT_THAT(source.notes,
              testing::ElementsAre(HasSubstr("1 of 5 messages came after later ones"),
                                   HasSubstr("1 of 5 messages have the stamp of another")));
  messages.push_back(image_message("/c/image_raw", 40 * kFrameNs, "mono8", grey(9)));
  messages.push_back(image_message("/c/image_raw", 5 * kFrameNs, "mono8", grey(9)));
  EXPECT_THAT(error_text([&] { open(mcap_of(messages)); }),
              AllOf(HasSubstr("/c/image_raw, message of 0.16"), HasSubstr("s earlier")));
}

TEST_F(RecordedSequence, WithoutStampsTheTimesOfRecordingCount) {
  std::vector<TestMessage> messages;
  for (const int frame : {0, 1, 2}) {
    messages.push_back(image_message("/c/image_raw", 0, "mono8", grey(frame)));
    messages.back().time_ns = frame * kFrameNs;
  }
  const auto source = open(mcap_of(messages));
  EXPECT_THAT(source.notes, testing::ElementsAre(HasSubstr("have no stamps")));
  ASSERT_EQ(source.timestamps.size(), 3U);
  EXPECT_NEAR(source.timestamps[2], 2 * 0.033333333, 1e-12);
}

TEST_F(RecordedSequence, CameraInfoMustFitTheImage) {
  vo::RosCameraInfo info = vo::camera_info_of(vo::PinholeCamera::from_horizontal_fov(8, 6, 60));
  const auto open_with = [&] {
    return vo::open_recording(
        folder.write("r.mcap", mcap_of({{"/c/camera_info", "sensor_msgs/msg/CameraInfo", 1,
                                         vo::encode_cdr(info)},
                                        image_message("/c/image_raw", 1, "mono8", grey(1))})),
        std::nullopt);
  };
  EXPECT_EQ(open_with().camera.pinhole.width, 8);
  info.width = 16;
  EXPECT_THAT(error_text(open_with), HasSubstr("is of 8x6 px, expected the camera's 16x6"));
  info.width = 8;
  info.distortion_model = "rational_polynomial";
  info.D = {0.1, 0, 0, 0, 0, 0.2, 0, 0, 0.3};
  EXPECT_THAT(error_text(open_with), HasSubstr("more than eight coefficients"));
  info.distortion_model = "ptam";
  EXPECT_THAT(error_text(open_with), HasSubstr("model 'ptam'"));
  info.K = {};
  EXPECT_THAT(error_text(open_with), HasSubstr("not calibrated"));
}

TEST_F(RecordedSequence, CameraInfoHoldsARationalLens) {
  vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(8, 6, 60);
  camera.distortion = {.k1 = 0.1,
                       .k2 = -0.02,
                       .p1 = 0.001,
                       .p2 = -0.002,
                       .k3 = 0.003,
                       .k4 = 0.2,
                       .k5 = -0.01,
                       .k6 = 0.004};
  const vo::RosCameraInfo info = vo::camera_info_of(camera);
  EXPECT_EQ(info.distortion_model, "rational_polynomial");
  const auto path = folder.write(
      "r.mcap", mcap_of({{"/c/camera_info", "sensor_msgs/msg/CameraInfo", 1, vo::encode_cdr(info)},
                         image_message("/c/image_raw", 1, "mono8", grey(1))}));
  const vo::Distortion lens = vo::open_recording(path, std::nullopt).camera.pinhole.distortion;
  EXPECT_EQ(lens.k2, -0.02);
  EXPECT_EQ(lens.p2, -0.002);
  EXPECT_EQ(lens.k3, 0.003);
  EXPECT_EQ(lens.k4, 0.2);
  EXPECT_EQ(lens.k5, -0.01);
  EXPECT_EQ(lens.k6, 0.004);
}

TEST_F(RecordedSequence, TheTruthIsWhereTfHasTheCameraBelowTheWorld) {
  std::vector<TestMessage> messages = {
      support::tf_message({support::pose_at_x(0, 0.1, "body", "camera")}, "/tf_static")};
  for (const int frame : {1, 2, 3}) {
    messages.push_back(image_message("/c/image_raw", frame * kFrameNs, "mono8", grey(frame)));
    messages.push_back(support::pose_message("/vicon", support::pose_at_x(frame, 7)));
    messages.push_back(
        support::tf_message({support::pose_at_x(frame * kFrameNs, frame, "world", "body")}));
  }
  const auto truth = open(mcap_of(messages)).truth;
  ASSERT_EQ(truth.size(), 3U);
  EXPECT_DOUBLE_EQ(truth[1].T_world_camera.translation().x(), 2.1) << "m";
  const auto chosen = open(mcap_of(messages), {.topics = {.truth = "/vicon"}}).truth;
  EXPECT_EQ(chosen.at(0).T_world_camera.translation().x(), 7) << "m";
  vo::RosPose none = support::pose_at_x(4 * kFrameNs, 0, "world", "body");
  none.rotation = {};
  messages.push_back(support::tf_message({none}));
  const auto source = open(mcap_of(messages));
  EXPECT_THAT(source.truth, IsEmpty());
  EXPECT_THAT(source.notes, testing::ElementsAre(HasSubstr("not taken for the truth")));
}

TEST_F(RecordedSequence, AFolderOfRos2HoldsOneRecording) {
  const fs::path recording = folder.path() / "talk";
  fs::create_directories(recording);
  const std::string bytes = mcap_of({image_message("/c/image_raw", 1, "mono8", grey(1))});
  vo::write_files(recording, {{"talk_0.mcap", bytes}, {"metadata.yaml", "rosbag2"}});
  const vo::SequenceReader reader(recording, tiny_camera(), 0.02, vo::SequenceContent::colour);
  EXPECT_EQ(reader.size(), 1U);
  vo::write_files(recording, {{"talk_1.mcap", bytes}});
  EXPECT_THAT(error_text([&] { vo::SequenceReader(recording, tiny_camera()); }),
              HasSubstr("holds several recordings (talk_0.mcap, talk_1.mcap)"));
}

TEST_F(RecordedSequence, TopicsAreForRecordings) {
  const fs::path path = folder.write("r.txt", "no recording");
  EXPECT_THAT(error_text([&] { vo::SequenceReader(path, tiny_camera()); }),
              HasSubstr("is no recording"));
  EXPECT_THAT(error_text([&] {
                vo::SequenceReader(folder.path(), tiny_camera(), 0.02, vo::SequenceContent::colour,
                                   {.image = "/c"});
              }),
              HasSubstr("of which topics are chosen"));
}

}  // namespace
