#include "tools/cameras/v4l2_camera.h"

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/same_pixels.h"
#include "tests/support/temp_folder.h"
#include "tests/support/video_files.h"
#include "tools/cameras/record.h"
#include "vo/dataset/sequence.h"

namespace {

namespace fs = std::filesystem;
using support::error_kind;
using support::error_text;
using support::have_same_pixels;
using support::noise_camera;
using support::noise_images;
using testing::HasSubstr;

const tools::RecordObserver kPatient = {[] { return false; }, [](std::size_t) {}};

/// A camera that gives images with stamps, and then nothing more.
vo::VideoCapture capture_of(const std::vector<cv::Mat>& images, const std::vector<double>& stamps) {
  const auto next = std::make_shared<std::atomic<std::size_t>>(0);
  return {.grab = [next, count = images.size()] { return ++*next <= count; },
          .image = [next, images] { return images.at(*next - 1); },
          .stamp = [next, stamps] { return stamps.at(*next - 1); }};
}

tools::LiveCamera camera_of(vo::VideoCapture capture) {
  return tools::live_camera_of("v4l2", "/dev/video0", std::move(capture),
                               {.camera = noise_camera()});
}

/// The way from a capture to a recording is tested on captures of files and of images in memory,
/// because a machine that tests has no camera of Video4Linux2.
class V4l2Camera : public testing::Test {
 protected:
  const support::TempFolder folder;
};

TEST_F(V4l2Camera, WhatACaptureOfOpenCVGivesIsRecordedAndReadBackWithoutDepth) {
#ifndef EDVO_HAS_VIDEO
  GTEST_SKIP() << "libopencv-videoio-dev was not found";
#endif
  const std::vector<cv::Mat> images = noise_images(9, 3);
  support::write_video_of(folder.path() / "video.avi", images, 25);
  const tools::LiveCamera camera =
      camera_of(*vo::video_library("test").open_file(folder.path() / "video.avi"));
  EXPECT_FALSE(camera.has_depth);
  const tools::RecordOutcome outcome =
      tools::record(camera, {folder.path() / "out", images.size()}, {}, kPatient);
  EXPECT_EQ(outcome.frames, images.size());
  EXPECT_EQ(outcome.missed, 0U);
  EXPECT_FALSE(fs::exists(folder.path() / "out/depth.txt"));
  EXPECT_FALSE(fs::exists(folder.path() / "out/depth"));
  const vo::SequenceReader recorded(folder.path() / "out", std::nullopt, 0.02,
                                    vo::SequenceContent::colour);
  ASSERT_EQ(recorded.size(), images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    EXPECT_EQ(recorded.timestamp(i), std::stod("0." + std::to_string(100 + 4 * i).substr(1)));
    EXPECT_TRUE(have_same_pixels(recorded.read(i).image, images[i])) << i;
  }
}

TEST_F(V4l2Camera, ImagesWithoutALaterStampAreMissed) {
  const std::vector<cv::Mat> images = noise_images(4, 3);
  const tools::LiveCamera camera = camera_of(capture_of(images, {1, 1, 0.5, 2}));
  const tools::RecordOutcome outcome =
      tools::record(camera, {folder.path() / "out", 2}, {}, kPatient);
  EXPECT_EQ(outcome.missed, 2U);
  EXPECT_EQ(outcome.duration_s, 1);
}

TEST_F(V4l2Camera, ImagesThatNobodyTakesAreMissedAndNotKept) {
  std::vector<double> stamps;
  for (int i = 0; i < 40; ++i) {
    stamps.push_back(i);
  }
  const tools::LiveCamera camera = camera_of(capture_of(noise_images(40, 3), stamps));
  while (camera.missed() < 10) {
    std::this_thread::yield();
  }
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(camera.next([] { return false; })->timestamp, i);
  }
  EXPECT_EQ(camera.next([] { return true; }), std::nullopt);
}

TEST_F(V4l2Camera, SaysWhenNothingComesForFiveSeconds) {
  const auto open_silent = [] { camera_of(capture_of({}, {})); };
  EXPECT_EQ(error_kind(open_silent), vo::ErrorKind::temporary);
  const tools::LiveCamera camera = camera_of(capture_of(noise_images(1, 3), {1}));
  EXPECT_TRUE(camera.next([] { return false; }).has_value());
  EXPECT_EQ(error_text([&] { camera.next([] { return false; }); }),
            "v4l2: has given no frame for 5 s");
}

TEST_F(V4l2Camera, SaysWhatADeviceDoesNotHave) {
  const auto error = [](const std::string& name, const tools::LiveCameraSettings& settings) {
    return error_text([&] { tools::open_live_camera(name, settings); });
  };
  const tools::LiveCameraSettings settings{.camera = noise_camera()};
  EXPECT_THAT(error("v4l2", {}), HasSubstr("v4l2: says nothing of its lens, expected --camera"));
  EXPECT_THAT(error("v4l2:/dev/video77", settings),
              HasSubstr("v4l2:/dev/video77: there is no /dev/video77, expected a camera"));
  EXPECT_THAT(error("v4l2:" + folder.path().string(), settings), HasSubstr(" is no device"));
  EXPECT_THAT(error("v4l2", {.camera = noise_camera(), .size = std::pair(640, 480)}),
              HasSubstr("v4l2: 640x480 px are asked for, the camera that was given has 96x64"));
  EXPECT_THAT(error_text([] { camera_of(capture_of({cv::Mat(32, 32, CV_8UC3)}, {1})); }),
              HasSubstr("v4l2: its images have 32x32 px, expected 96x64"));
#ifdef EDVO_HAS_VIDEO
  EXPECT_THAT(error("v4l2:/dev/null", settings),
              HasSubstr("v4l2:/dev/null: /dev/null does not start: it captures no images"));
#endif
}

TEST_F(V4l2Camera, IsNamedByItsLibraryAndDevice) {
  EXPECT_TRUE(tools::is_live_camera("v4l2"));
  EXPECT_TRUE(tools::is_live_camera("v4l2:/dev/video1"));
  EXPECT_FALSE(tools::is_live_camera("v4l2_folder"));
}

}  // namespace
