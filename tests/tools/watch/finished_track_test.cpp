#include "tools/watch/finished_track.h"

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/error_text.h"
#include "tests/support/plane_frames.h"
#include "tests/support/temp_folder.h"
#include "vo/files/input.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/sequence_odometry/time_log.h"

namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using support::error_text;
using testing::ElementsAre;
using testing::HasSubstr;

/// The sway, at the end of which a hand is before the lens, tracked into the files of a track.
class FinishedTrack : public testing::Test {
 protected:
  FinishedTrack() {
    const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(160, 120, 60);
    vo::RgbdOdometry odometry(camera);
    for (int i = 0; i < kFrames; ++i) {
      result_.frames.push_back(odometry.track(i < kCovered ? support::sway_frame(camera, i)
                                                           : support::blank_frame(camera, 0, i)));
      result_.times.push_back(odometry.stage_times());
    }
    result_.trajectory = odometry.trajectory();
    files_.write("e.txt", vo::format_trajectory(result_.trajectory));
    files_.write("e.csv", vo::format_frame_log(result_.frames));
    files_.write("e_times.csv", vo::format_time_log(result_));
  }

  fs::path file(const std::string& name) const { return files_.path() / name; }

  tools::FinishedTrack read() const {
    return tools::read_finished_track(tools::with_files_beside(
        {.trajectory = file("e.txt"), .frame_log = {}, .time_log = {}, .panels = {}}));
  }

  /// Writes a panel of six pictures, each of one grey.
  void write_panel(const std::string& name, int width = 96) const {
    cv::Mat_<cv::Vec3b> panel(64, width);
    for (int v = 0; v < panel.rows; ++v) {
      for (int u = 0; u < panel.cols; ++u) {
        panel(v, u) = cv::Vec3b::all(static_cast<uchar>(40 * (u / 32) + 120 * (v / 32)));
      }
    }
    files_.write("e_panels/" + name, vo::encode_png(panel));
  }

  /// The data of all events of a name that a feed tells.
  static std::vector<json> told(tools::EventFeed& feed, const std::string& name) {
    std::string text;
    tools::EventFeed::Place place;
    for (;;) {
      const std::string more = feed.read(place, std::chrono::milliseconds(0));
      if (more.empty()) {
        break;
      }
      text += more;
    }
    std::vector<json> events;
    const std::string head = "event: " + name + "\ndata: ";
    for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, at + 1)) {
      const std::size_t begin = at + head.size();
      events.push_back(json::parse(text.substr(begin, text.find('\n', begin) - begin)));
    }
    return events;
  }

  static constexpr int kFrames = 12;
  static constexpr int kCovered = 9;
  vo::SequenceResult result_;
  support::TempFolder files_;
};

TEST_F(FinishedTrack, IsToldAsItWasWhileItRan) {
  tools::EventFeed feed;
  tell(read(), feed);
  const std::vector<json> frames = told(feed, "frame");
  ASSERT_EQ(frames.size(), result_.frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    json live = json::parse(
        tools::frame_text({.index = i, .result = result_.frames[i], .times = result_.times[i]}));
    json done = frames[i];
    ASSERT_EQ(done["pose"].is_null(), live["pose"].is_null()) << i;
    for (std::size_t k = 0; k < live["pose"].size(); ++k) {
      EXPECT_NEAR(done["pose"][k].get<double>(), live["pose"][k].get<double>(), 1e-9);
    }
    EXPECT_NEAR(done["timestamp"].get<double>(), live["timestamp"].get<double>(), 1e-6);
    for (const char* rounded : {"pose", "timestamp"}) {
      live.erase(rounded);
      done.erase(rounded);
    }
    EXPECT_EQ(done, live);
  }
  EXPECT_EQ(frames.back()["status"], "lost");
  EXPECT_EQ(told(feed, "stage").at(0)["title"], "e.txt");
  EXPECT_EQ(told(feed, "end").at(0)["how"], "9 of 12 frames have a pose");
}

TEST_F(FinishedTrack, HasThePicturesOfItsPanels) {
  write_panel("000004.png");
  write_panel("000000.png");
  files_.write("e_panels/.edvo-files", "");
  tools::EventFeed feed;
  tell(read(), feed);
  const std::vector<json> pictures = told(feed, "pictures");
  ASSERT_EQ(pictures.size(), 2U);
  EXPECT_EQ(pictures[0]["frame"], 0);
  EXPECT_EQ(pictures[1]["frame"], 4);
  EXPECT_THAT(pictures[1]["size"].get<std::vector<int>>(), ElementsAre(32, 32));
  std::set<std::string> different;
  for (const char* kind : {"colour", "edges", "residual_before", "residual_after"}) {
    different.insert(pictures[1][kind].get<std::string>());
  }
  EXPECT_EQ(different.size(), 4U) << "of four greys";
  EXPECT_EQ(told(feed, "end").at(0)["frames_without_pictures"], 10);
}

TEST_F(FinishedTrack, WithoutALogHasItsPosesAlone) {
  fs::remove(file("e.csv"));
  fs::remove(file("e_times.csv"));
  const tools::FinishedTrack track = read();
  EXPECT_EQ(track.frames.size(), result_.trajectory.size());
  EXPECT_EQ(track.poses(), result_.trajectory.size());
}

TEST_F(FinishedTrack, OfALogThatIsNoneIsNamed) {
  const auto error_with = [&](const std::string& name, const std::string& bytes) {
    const std::string before = vo::read_file(file(name));
    files_.write(name, bytes);
    const std::string text = error_text([&] { read(); });
    files_.write(name, before);
    return text;
  };
  EXPECT_THAT(error_with("e.csv", "a,b\n1,2\n"), HasSubstr("e.csv: is no log of frames"));
  EXPECT_THAT(error_with("e.csv", "timestamp,status\n0\n"),
              HasSubstr("e.csv:2: has 1 cells, expected 2"));
  const std::string columns = "timestamp,status,reason,keyframe\n";
  EXPECT_THAT(error_with("e.csv", columns + "0,found,none,1\n"), HasSubstr("e.csv:2: status: "));
  EXPECT_THAT(error_with("e.csv", columns + "zero,lost,none,1\n"),
              HasSubstr("e.csv:2: timestamp: expected a number, got 'zero'"));
  EXPECT_THAT(error_with("e.csv", columns + "7,tracked,none,1\n"),
              HasSubstr("e.csv: is the log of another track: 0 of its frames"));
  EXPECT_THAT(error_with("e_times.csv", "timestamp,pyramid_ms,edges_ms,alignment_ms,mapping_ms\n"),
              HasSubstr("e_times.csv: has the times of 0 frames, expected 12"));
}

TEST_F(FinishedTrack, OfPanelsThatAreNoneIsNamed) {
  write_panel("000012.png");
  EXPECT_THAT(error_text([&] { read(); }), HasSubstr("000012.png: is of frame 12"));
  fs::remove(file("e_panels/000012.png"));
  write_panel("000003.png", 95);
  tools::EventFeed feed;
  EXPECT_THAT(error_text([&] { tell(read(), feed); }), HasSubstr("000003.png: is no panel"));
}

}  // namespace
