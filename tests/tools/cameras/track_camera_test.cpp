#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/plane_sequence.h"
#include "tests/support/program_test.h"
#include "vo/dataset/sequence.h"

namespace {

using nlohmann::json;
using support::ProgramResult;
using support::run_program;
using testing::HasSubstr;

constexpr int kShown = 7;  // frames, which the driver's camera shows over and over

/// Tracks the driver's camera, which gives a frame each millisecond.
class TrackCamera : public support::ProgramTest {
 protected:
  void SetUp() override {
#ifndef EDVO_OPENNI2_FOLDER
    GTEST_SKIP() << "libopenni2-dev was not found";
#else
    support::write_plane_sequence(file("sequence"), kShown);
#endif
  }

  ProgramResult run(const std::string& words, const std::string& variables = "") const {
#ifdef EDVO_OPENNI2_FOLDER
    return run_program(words, "LD_LIBRARY_PATH='" EDVO_OPENNI2_FOLDER "' EDVO_DEVICE_FOLDER=" +
                                  path("sequence") + " " + variables + " ");
#else
    return run_program(words + variables);
#endif
  }

  ProgramResult track(const std::string& rest, const std::string& variables = "") const {
    return run("track openni2 --quiet --json --out " + path("live.txt") + " --frame-log " +
                   path("live.csv") + " " + rest,
               variables);
  }

  /// The stamps of all frames that were tracked, as the frame log has them.
  std::vector<double> logged_stamps() const {
    std::istringstream log(read("live.csv"));
    std::vector<double> stamps;
    std::string line;
    for (std::getline(log, line); std::getline(log, line);) {
      stamps.push_back(std::stod(line));
    }
    return stamps;
  }

  /// Writes the frames that the device had at these stamps as a sequence, with the camera that a
  /// recording says it has.
  void write_as_sequence(const std::vector<double>& stamps) const {
    ASSERT_EQ(run("record openni2 " + path("recorded") + " --frames 1 --quiet").exit_code, 0);
    const vo::SequenceLayout layout{vo::SequenceReader(file("recorded")).camera()};
    const vo::SequenceReader shown(file("sequence"));
    for (std::size_t i = 0; i < stamps.size(); ++i) {
      const double index = (stamps[i] - 1) / 0.033333;
      ASSERT_NEAR(index, std::round(index), 1e-6);
      vo::RgbdFrame frame = shown.read(static_cast<std::size_t>(std::lround(index)) % kShown);
      cv::cvtColor(frame.image, frame.image, cv::COLOR_GRAY2BGR);
      frame.timestamp = stamps[i];
      vo::write_files(file("same"), vo::encode_frame(layout, i, frame));
    }
    vo::write_files(file("same"), vo::encode_image_lists(layout, stamps, stamps));
  }
};

TEST_F(TrackCamera, ComesToWhatTheSequenceOfItsFramesComesTo) {
  const ProgramResult live = track("--frames 8");
  ASSERT_TRUE(live.exit_code == 0 || live.exit_code == 5) << live.err;
  const json summary = json::parse(live.out);
  EXPECT_EQ(summary["frames"], 8);
  EXPECT_EQ(summary["camera"]["device"], "edvo Sequence (folder)");
  const std::vector<double> stamps = logged_stamps();
  ASSERT_EQ(stamps.size(), 8U);
  EXPECT_TRUE(std::is_sorted(stamps.begin(), stamps.end()));
  // How many are dropped depends on the machine, and OpenNI2 drops some before anyone is told of
  // them.
  EXPECT_TRUE(summary["camera"]["dropped"].is_number_unsigned());
  write_as_sequence(stamps);
  const ProgramResult same = run_program("track " + path("same") + " --quiet --out " +
                                         path("same.txt") + " --frame-log " + path("same.csv"));
  EXPECT_EQ(same.exit_code, live.exit_code) << same.err;
  EXPECT_EQ(read("same.txt"), read("live.txt"));
  EXPECT_EQ(read("same.csv"), read("live.csv"));
  EXPECT_EQ(read("same_config.toml"), read("live_config.toml"));
}

TEST_F(TrackCamera, EndsWellByCtrlC) {
  const ProgramResult live = track("--save-map " + path("map.ply"), "EDVO_DEVICE_SIGINT=60");
  ASSERT_TRUE(live.exit_code == 0 || live.exit_code == 5) << live.exit_code << live.err;
  const json summary = json::parse(live.out);
  EXPECT_EQ(summary["frames"].get<std::size_t>(), logged_stamps().size());
  EXPECT_GT(logged_stamps().size(), 0U);
  EXPECT_TRUE(summary["camera"]["dropped"].is_number_unsigned());
  EXPECT_TRUE(exists("live.txt") && exists("map.ply"));
  EXPECT_FALSE(has_leftovers());
}

TEST_F(TrackCamera, ShowsItselfWhileItRuns) {
  const ProgramResult live = track("--live --live-keep", "EDVO_DEVICE_SIGINT=60");
  ASSERT_TRUE(live.exit_code == 0 || live.exit_code == 5 || live.exit_code == 2) << live.err;
  if (live.exit_code == 2) {
    GTEST_SKIP() << "built without an HTTP library: " << live.err;
  }
  EXPECT_THAT(live.err, HasSubstr("live at http://127.0.0.1:"));
  EXPECT_TRUE(exists("live.txt"));
}

TEST_F(TrackCamera, TakesImagesAloneInModeMono) {
  const ProgramResult mono =
      run("track openni2 --mode mono --bootstrap rgbd --frames 6 --quiet --json --out " +
          path("mono.txt"));
  ASSERT_TRUE(mono.exit_code == 0 || mono.exit_code == 5) << mono.err;
  const json summary = json::parse(mono.out);
  EXPECT_EQ(summary["mode"], "mono");
  EXPECT_EQ(summary["frames"], 6);
  EXPECT_TRUE(summary["camera"].contains("dropped"));
}

TEST_F(TrackCamera, RefusesWhatOnlyASequenceHas) {
  for (const std::string& option :
       {std::string("--debug-images 2"), "--mode mono --depth-file " + path("d.png"),
        std::string("--rgb-topic /a")}) {
    const ProgramResult live = track(option);
    EXPECT_EQ(live.exit_code, 2) << option;
    EXPECT_THAT(live.err, HasSubstr("expected a sequence")) << option;
  }
  for (const std::string option : {"--frames 3", "--size 160x120"}) {
    const ProgramResult folder =
        run_program("track " + path("sequence") + " --out " + path("a.txt") + " " + option);
    EXPECT_EQ(folder.exit_code, 2) << option;
    EXPECT_THAT(folder.err, HasSubstr("expected a camera")) << option;
  }
  EXPECT_FALSE(exists("live.txt"));
}

TEST_F(TrackCamera, SaysThatThereIsNoDevice) {
  const ProgramResult none =
      run_program("track v4l2:/dev/none --mode mono --camera tum-fr1 --out " + path("a.txt"));
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_THAT(none.err, HasSubstr("there is no /dev/none"));
  EXPECT_FALSE(exists("a.txt"));
}

}  // namespace
