#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/plane_sequence.h"
#include "tests/support/program_test.h"
#include "tests/support/same_pixels.h"
#include "tools/cameras/live_camera.h"
#include "vo/dataset/sequence.h"
#include "vo/frames/depth_units.h"

namespace {

using support::have_same_pixels;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

constexpr int kFrames = 7;

/// Records the driver's camera, which shows a sequence over and over.
class Record : public support::ProgramTest {
 protected:
  void SetUp() override {
#ifndef EDVO_OPENNI2_FOLDER
    GTEST_SKIP() << "libopenni2-dev was not found";
#else
    write_sequence();
#endif
  }

  /// Writes the plane's sequence in three colours that differ.
  void write_sequence() const {
    support::write_plane_sequence(file("sequence"), kFrames);
    const vo::SequenceReader grey(file("sequence"));
    const vo::SequenceLayout layout{grey.camera()};
    for (std::size_t i = 0; i < grey.size(); ++i) {
      vo::RgbdFrame frame = grey.read(i);
      vo::ColorImage colours(frame.image.size());
      for (int v = 0; v < colours.rows; ++v) {
        for (int u = 0; u < colours.cols; ++u) {
          const uchar value = frame.image.at<uchar>(v, u);
          colours(v, u) = {value, static_cast<uchar>(value / 2), static_cast<uchar>(255 - value)};
        }
      }
      frame.image = colours;
      vo::write_files(file("sequence"), vo::encode_frame(layout, i, frame),
                      {vo::ExistingOutput::replace, vo::Durability::unsynced});
    }
  }

  ProgramResult record(const std::string& rest, const std::string& variables = "") const {
#ifdef EDVO_OPENNI2_FOLDER
    return run_program("record " + rest + " --quiet", "LD_LIBRARY_PATH='" EDVO_OPENNI2_FOLDER
                                                      "' EDVO_DEVICE_FOLDER=" +
                                                          path("sequence") + " " + variables + " ");
#else
    return run_program("record " + rest + variables);
#endif
  }

  /// Expects each frame of a recording to be that of the sequence which the device had at its
  /// stamp.
  void expect_frames_of_the_device(const std::string& recording, std::size_t frames) const {
    const vo::SequenceReader given(file("sequence"));
    const vo::SequenceReader recorded(file(recording));
    EXPECT_EQ(recorded.size(), frames);
    for (std::size_t i = 0; i < recorded.size(); ++i) {
      const vo::RgbdFrame frame = recorded.read(i);
      const double index = (frame.timestamp - 1) / 0.033333;
      ASSERT_NEAR(index, std::round(index), 1e-6);
      const vo::RgbdFrame truth = given.read(std::lround(index) % kFrames);
      EXPECT_TRUE(have_same_pixels(frame.image, truth.image)) << frame.timestamp;
      EXPECT_TRUE(have_same_pixels(vo::to_depth_units(frame.depth, 1000),
                                   vo::to_depth_units(truth.depth, 1000)))
          << frame.timestamp;
    }
  }
};

TEST_F(Record, WritesTheFramesAndTheCameraOfTheDevice) {
  const ProgramResult result = record("openni2 " + path("out") + " --frames 5 --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_frames_of_the_device("out", 5);
  const vo::RgbdCamera camera = vo::SequenceReader(file("out")).camera();
  const vo::RgbdCamera truth = vo::SequenceReader(file("sequence")).camera();
  EXPECT_NEAR(camera.pinhole.fx, truth.pinhole.fx, 1e-4);
  EXPECT_NEAR(camera.pinhole.fy, truth.pinhole.fy, 1e-4);
  EXPECT_EQ(camera.pinhole.cx, truth.pinhole.cx);
  EXPECT_EQ(camera.depth_units_per_m, 1000) << "the device's, in mm";
  const auto summary = nlohmann::json::parse(result.out);
  EXPECT_EQ(summary["frames"], 5);
  EXPECT_EQ(summary["device"], "edvo Sequence (folder)");
  EXPECT_FALSE(has_leftovers());
}

TEST_F(Record, WhatIsRecordedIsTracked) {
  ASSERT_EQ(record("openni2:folder " + path("out") + " --frames 4").exit_code, 0);
  const ProgramResult tracked =
      run_program("track " + path("out") + " --out " + path("track.txt") + " --quiet --json");
  ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
  EXPECT_EQ(nlohmann::json::parse(tracked.out)["tracked_fraction"], 1.0);
}

TEST_F(Record, CtrlCEndsARecordingAndKeepsIt) {
  const ProgramResult result = record("openni2 " + path("out") + " --json", "EDVO_DEVICE_SIGINT=9");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::size_t frames = nlohmann::json::parse(result.out)["frames"];
  EXPECT_GT(frames, 0U);
  expect_frames_of_the_device("out", frames);
  EXPECT_FALSE(has_leftovers());
}

TEST_F(Record, AFullDiskIsSaidAndLeavesNothing) {
#ifdef EDVO_OPENNI2_FOLDER
  const ProgramResult result = run_program(
      "record openni2 " + path("out") + " --quiet --frames 900",
      "ulimit -f 2; export LD_LIBRARY_PATH='" EDVO_OPENNI2_FOLDER "' EDVO_DEVICE_FOLDER=" +
          path("sequence") + "; ");
  EXPECT_EQ(result.exit_code, 75);
  EXPECT_THAT(result.err, HasSubstr("rgb/000000.png"));
  EXPECT_FALSE(exists("out"));
  EXPECT_FALSE(has_leftovers());
#endif
}

TEST_F(Record, SaysWhatADeviceDoesNotHave) {
  const ProgramResult size = record("openni2 " + path("out") + " --size 640x480");
  EXPECT_EQ(size.exit_code, 3);
  EXPECT_THAT(size.err, HasSubstr("openni2: has no colour (RGB) and depth (1 mm or 0.1 mm) of "
                                  "640x480 px"));
  const ProgramResult camera = record("openni2 " + path("out") + " --camera tum-fr1");
  EXPECT_EQ(camera.exit_code, 3);
  EXPECT_THAT(camera.err, HasSubstr("its images have 160x120 px"));
  const ProgramResult other = record("openni2:other " + path("out"));
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("openni2:other: cannot be opened"));
  EXPECT_FALSE(exists("out"));
}

TEST_F(Record, NoDeviceIsAnErrorThatSaysSo) {
#ifdef EDVO_OPENNI2_FOLDER
  const ProgramResult none =
      run_program("record openni2 " + path("out"), "LD_LIBRARY_PATH='" EDVO_OPENNI2_FOLDER "' ");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, HasSubstr("no devices found"));
#endif
}

TEST(LiveCameraName, IsThatOfALibraryAndNoFolder) {
  EXPECT_TRUE(tools::is_live_camera("openni2"));
  EXPECT_TRUE(tools::is_live_camera("openni2:device.oni"));
  EXPECT_FALSE(tools::is_live_camera("openni2_sequence"));
  EXPECT_FALSE(tools::is_live_camera("./openni2"));
  EXPECT_FALSE(tools::is_live_camera(""));
}

}  // namespace
