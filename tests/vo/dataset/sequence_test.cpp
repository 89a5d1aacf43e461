#include "vo/dataset/sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/plane_sequence.h"
#include "tests/support/temp_folder.h"
#include "vo/dataset/camera_file.h"
#include "vo/files/input.h"
#include "vo/files/output.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

constexpr int kSequenceFrames = 4;

vo::RgbdCamera tiny_camera() {
  return {vo::PinholeCamera::from_horizontal_fov(12, 8, 70), 5000};
}

vo::RgbdFrame tiny_frame(int index, double timestamp) {
  vo::RgbdFrame frame{timestamp, cv::Mat(8, 12, CV_8UC3), vo::DepthImage(8, 12)};
  for (int v = 0; v < 8; ++v) {
    for (int u = 0; u < 12; ++u) {
      frame.image.at<cv::Vec3b>(v, u) = {static_cast<uchar>(10 * u), static_cast<uchar>(20 * v),
                                         static_cast<uchar>(index)};
      frame.depth(v, u) = u == 0 ? 0.0F : 0.5F + 0.1F * static_cast<float>(u + v + index);
    }
  }
  return frame;
}

vo::Trajectory write_sequence(const TempFolder& folder) {
  const vo::Trajectory truth = support::example_trajectory(kSequenceFrames, 30);
  const vo::SequenceLayout layout{tiny_camera(), vo::FloatDepth::npy};
  for (int i = 0; i < kSequenceFrames; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const vo::RgbdFrame frame = tiny_frame(i, truth[index].timestamp);
    vo::write_files(folder.path(), vo::encode_frame(layout, index, frame));
  }
  vo::write_files(folder.path(), vo::encode_lists(layout, truth));
  return truth;
}

void replace(const TempFolder& folder, const char* name, const std::string& text) {
  vo::write_file(folder.path() / name, text, vo::ExistingOutput::replace);
}

std::string read_error(const TempFolder& folder) {
  return error_text([&] {
    const vo::SequenceReader reader(folder.path());
    vo::FrameStream stream(reader);
    while (stream.next()) {
    }
  });
}

TEST(Sequence, ReadInvertsWrite) {
  const TempFolder folder;
  const vo::Trajectory truth = write_sequence(folder);
  const vo::SequenceReader reader(folder.path());
  ASSERT_EQ(reader.size(), truth.size());
  EXPECT_EQ(vo::format_camera(reader.camera()), vo::format_camera(tiny_camera()));
  EXPECT_EQ(reader.ground_truth().size(), truth.size());
  vo::FrameStream stream(reader);
  for (int i = 0; i < kSequenceFrames; ++i) {
    const auto frame = stream.next();
    ASSERT_TRUE(frame.has_value());
    const vo::RgbdFrame expected = tiny_frame(i, truth[static_cast<std::size_t>(i)].timestamp);
    EXPECT_NEAR(frame->timestamp, expected.timestamp, 1e-6);
    EXPECT_EQ(frame->depth_delay, 0);
    EXPECT_EQ(cv::norm(frame->image, expected.image, cv::NORM_INF), 0);
    EXPECT_LE(cv::norm(frame->depth, expected.depth, cv::NORM_INF), 0.5 / 5000 + 1e-7);
  }
  EXPECT_FALSE(stream.next().has_value());
}

TEST(Sequence, FloatDepthIsExact) {
  const TempFolder folder;
  write_sequence(folder);
  const cv::Mat_<float> depth = vo::read_npy(folder.path() / "depth_float/000002.npy");
  EXPECT_EQ(cv::norm(depth, tiny_frame(2, 0).depth, cv::NORM_INF), 0);
}

TEST(Sequence, DepthBeyondSixteenBitsIsNoMeasurement) {
  const TempFolder folder;
  const vo::SequenceLayout layout{tiny_camera()};
  vo::RgbdFrame frame = tiny_frame(0, 0);
  frame.depth.setTo(20.0F);
  vo::write_files(folder.path(), vo::encode_frame(layout, 0, frame));
  vo::write_files(folder.path(), vo::encode_lists(layout, {{0, {}}}));
  const vo::RgbdFrame read = vo::SequenceReader(folder.path()).read(0);
  EXPECT_EQ(cv::countNonZero(read.depth), 0);
}

TEST(Sequence, PairsColourAndDepthByNearestStampOnce) {
  const TempFolder folder;
  write_sequence(folder);
  replace(folder, "rgb.txt", "0.00 rgb/000000.png\n0.03 rgb/000001.png\n0.50 rgb/000002.png\n");
  replace(folder, "depth.txt", "0.012 depth/000003.png\n0.025 depth/000001.png\n");
  const vo::SequenceReader reader(folder.path());
  ASSERT_EQ(reader.size(), 2U);
  EXPECT_EQ(reader.timestamp(1), 0.03);
  EXPECT_LE(cv::norm(reader.read(0).depth, tiny_frame(3, 0).depth, cv::NORM_INF), 2e-4);
  EXPECT_NEAR(reader.read(0).depth_delay, 0.012, 1e-9);
  EXPECT_NEAR(reader.read(1).depth_delay, -0.005, 1e-9);
  ASSERT_EQ(reader.notes().size(), 1U);
  EXPECT_EQ(reader.notes().front(),
            "1 of 3 colour images have no depth image within 0.02 s and are left out");
}

TEST(Sequence, ErrorsNameFileAndLine) {
  const TempFolder folder;
  write_sequence(folder);
  replace(folder, "rgb.txt", "0.1 rgb/000000.png\n0.05 rgb/000001.png\n");
  EXPECT_THAT(read_error(folder), EndsWith("rgb.txt:2: expected a stamp after the one before it, "
                                           "got 0.05"));
  replace(folder, "rgb.txt", "0.1 rgb/000000.png\n0.1 rgb/000001.png\n");
  EXPECT_THAT(read_error(folder), HasSubstr("rgb.txt:2: expected a stamp after"));
  replace(folder, "rgb.txt", "# nothing\n");
  EXPECT_THAT(read_error(folder), EndsWith("rgb.txt: lists no images"));
  replace(folder, "rgb.txt", "0.1\n");
  EXPECT_THAT(read_error(folder), EndsWith("rgb.txt:1: expected `timestamp path`, got 1 values"));
  replace(folder, "rgb.txt", "9 rgb/000000.png\n");
  EXPECT_THAT(read_error(folder), HasSubstr("no colour and depth image lie within 0.02 s"));
}

TEST(Sequence, ErrorsNameTheImage) {
  const TempFolder folder;
  write_sequence(folder);
  const auto depth_path = folder.path() / "depth/000001.png";
  const std::string depth = vo::read_file(depth_path);
  replace(folder, "depth/000001.png", depth.substr(0, depth.size() / 2));
  EXPECT_THAT(read_error(folder), HasSubstr("000001.png: cannot be decoded: it is truncated"));
  replace(folder, "depth/000001.png", vo::encode_png(cv::Mat::zeros(8, 12, CV_8UC1)));
  EXPECT_THAT(read_error(folder),
              HasSubstr("000001.png: expected depth of 16 bits in one channel, got 8 bits"));
  replace(folder, "depth/000001.png", vo::encode_png(cv::Mat::zeros(8, 13, CV_16UC1)));
  EXPECT_THAT(read_error(folder), HasSubstr("000001.png: is 13x8 px, expected the camera's 12x8"));
  replace(folder, "depth/000001.png", depth);
  replace(folder, "rgb/000001.png", vo::encode_png(cv::Mat::zeros(8, 12, CV_16UC1)));
  EXPECT_THAT(read_error(folder), EndsWith("expected 8 bits per channel, got 16"));
}

TEST(Sequence, AMissingFolderOrCameraSaysWhatWasExpected) {
  const TempFolder folder;
  EXPECT_THAT(error_text([&] { const vo::SequenceReader reader(folder.path() / "none"); }),
              HasSubstr("none: there is no such folder, expected a sequence"));
  EXPECT_THAT(error_text([&] { const vo::SequenceReader reader(folder.path()); }),
              HasSubstr("has no camera.toml; name the camera with --camera"));
  const auto read = [&] { const vo::SequenceReader reader(folder.path(), tiny_camera()); };
  EXPECT_THAT(error_text(read), EndsWith("rgb.txt: there is no such file"));
}

TEST(Sequence, ColourAloneNeedsNoDepth) {
  const TempFolder folder;
  support::write_plane_sequence(folder.path(), 3);
  std::filesystem::remove(folder.path() / "depth.txt");
  std::filesystem::remove_all(folder.path() / "depth");
  const vo::SequenceReader reader(folder.path(), std::nullopt, 0.02, vo::SequenceContent::colour);
  ASSERT_EQ(reader.size(), 3U);
  EXPECT_EQ(reader.read(2).image.size(), cv::Size(160, 120));
  EXPECT_TRUE(reader.read(2).depth.empty());
}

TEST(Sequence, ReadsTheBenchmarksFiles) {
  const std::filesystem::path clip = std::filesystem::path(EDVO_SHARED_DATA) / "tum_fr1_xyz_color";
  if (!std::filesystem::exists(clip)) {
    GTEST_SKIP() << "no TUM data at " << clip;
  }
  const vo::SequenceReader reader(clip, vo::load_camera("tum-fr1"));
  ASSERT_GT(reader.size(), 15U);
  EXPECT_FALSE(reader.ground_truth().empty());
  const vo::RgbdFrame frame = reader.read(0);
  EXPECT_EQ(frame.image.type(), CV_8UC3);
  EXPECT_EQ(frame.depth.size(), cv::Size(640, 480));
}

}  // namespace
