#include "tools/watch/run_watch.h"

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/http_request.h"
#include "tests/support/plane_frames.h"
#include "tools/watch/page_process.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/motion_files/timestamp.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

const vo::PinholeCamera& watched_camera() {
  static const vo::PinholeCamera camera = vo::PinholeCamera::from_horizontal_fov(160, 120, 60);
  return camera;
}

/// Tracks the sway, a hand before the lens from some frame on, and calls the observer.
vo::SequenceResult track_sway(int frames, int covered_from, const vo::FrameObserver& observe) {
  vo::RgbdOdometry odometry(watched_camera());
  vo::SequenceResult result;
  for (int i = 0; i < frames; ++i) {
    const vo::RgbdFrame frame = i < covered_from ? support::sway_frame(watched_camera(), i)
                                                 : support::blank_frame(watched_camera(), 0, i);
    result.frames.push_back(odometry.track(frame));
    result.times.push_back(odometry.stage_times());
    if (observe) {
      observe(frame, odometry.current(), odometry.tracker(), result.frames.back(),
              odometry.stage_times());
    }
  }
  result.trajectory = odometry.trajectory();
  return result;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

TEST(FrameText, HasTheFiguresOfTheFrameLog) {
  const vo::SequenceResult result = track_sway(12, 9, {});
  std::stringstream log(vo::format_frame_log(result.frames));
  std::string line;
  std::getline(log, line);
  const std::vector<std::string> titles = split(line);
  const auto cell_of = [&](const std::string& title) {
    return split(line).at(
        static_cast<std::size_t>(std::find(titles.begin(), titles.end(), title) - titles.begin()));
  };
  std::set<std::string> statuses;
  for (std::size_t i = 0; i < result.frames.size(); ++i) {
    std::getline(log, line);
    const json frame = json::parse(
        tools::frame_text({.index = i, .result = result.frames[i], .times = result.times[i]}));
    EXPECT_EQ(vo::format_timestamp(frame["timestamp"].get<double>()), cell_of("timestamp"));
    for (const char* name : {"status", "reason", "termination"}) {
      EXPECT_EQ(frame[name], cell_of(name)) << name;
    }
    EXPECT_EQ(frame["keyframe"].get<bool>(), cell_of("keyframe") == "1");
    for (const char* name :
         {"iterations", "points", "visible_fraction", "correlation", "cost", "moving_fraction"}) {
      EXPECT_EQ(frame[name].get<double>(), vo::parse_real(cell_of(name))) << name;
    }
    std::size_t at = 0;
    for (const char* name : {"tx_tx", "tx_ty", "tx_tz", "ty_ty", "ty_tz", "tz_tz"}) {
      EXPECT_EQ(frame["position_covariance"][at++].get<double>(),
                vo::parse_real(cell_of(std::string("absolute_covariance_") + name)));
    }
    EXPECT_EQ(frame["pose"].is_null(), cell_of("status") == "lost");
    statuses.insert(cell_of("status"));
  }
  EXPECT_EQ(statuses.size(), 3U) << "initialized, tracked, lost";
}

class RunWatch : public testing::Test {
 protected:
  void SetUp() override {
    try {
      watch_ = std::make_unique<tools::RunWatch>(tools::WatchOptions{}, nullptr);
    } catch (const vo::Error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// Connects a viewer and waits until it is told something.
  std::unique_ptr<support::Connection> viewer() {
    const support::LocalUrl url(watch_->url());
    auto connection = std::make_unique<support::Connection>(url.port);
    connection->send(
        support::request_text("GET", "/events" + url.query, "Host: " + url.host() + "\r\n"));
    watch_->begin({.name = "tracking", .title = "sway", .frames = 40, .camera = watched_camera()});
    connection->read_until("\"sway\"");
    return connection;
  }

  std::unique_ptr<tools::RunWatch> watch_;
};

TEST_F(RunWatch, ChangesNothingThatIsTracked) {
  const auto seen = viewer();
  const vo::SequenceResult watched = track_sway(20, 20, watch_->observer({}));
  const vo::SequenceResult alone = track_sway(20, 20, {});
  EXPECT_EQ(vo::format_frame_log(watched.frames), vo::format_frame_log(alone.frames));
}

TEST_F(RunWatch, TellsEveryFrameAndDrawsWhatItHasTimeFor) {
  const auto seen = viewer();
  int others = 0;
  const int frames = 40;
  track_sway(frames, frames,
             watch_->observer([&](const auto&, const auto&, const auto&, const auto&, const auto&) {
               ++others;
             }));
  watch_->finish("all is well");
  watch_->begin({.name = "next", .title = "", .frames = 0});
  const std::string told = seen->read_until("\"next\"");
  for (int i = 0; i < frames; ++i) {
    EXPECT_THAT(told, HasSubstr("event: frame\ndata: {\"frame\":" + std::to_string(i) + ","));
  }
  EXPECT_THAT(told, HasSubstr("\"how\":\"all is well\""));
  EXPECT_EQ(others, frames);
  EXPECT_LT(watch_->frames_without_pictures(), static_cast<std::size_t>(frames))
      << "the first was wanted";
}

/// A viewer who never reads fills his own socket and nothing else, so the run goes on to its end.
TEST_F(RunWatch, DropsPicturesForAViewerWhoNeverReads) {
  const auto idle = viewer();
  const int frames = 200;
  const vo::FrameObserver observe = watch_->observer({});
  vo::RgbdOdometry odometry(watched_camera());
  const vo::RgbdFrame frame = support::sway_frame(watched_camera(), 0);
  const vo::TrackingResult result = odometry.track(frame);
  for (int i = 0; i < frames; ++i) {
    observe(frame, odometry.current(), odometry.tracker(), result, odometry.stage_times());
  }
  EXPECT_GT(watch_->frames_without_pictures(), 0U);
  EXPECT_LT(watch_->frames_without_pictures(), static_cast<std::size_t>(frames));
}

TEST_F(RunWatch, TakesNoPicturesWithoutAViewer) {
  track_sway(10, 10, watch_->observer({}));
  EXPECT_EQ(watch_->frames_without_pictures(), 10U);
}

TEST(PageProcess, TellsItsViewersWhatItIsToldAndEnds) {
  std::unique_ptr<tools::PageProcess> page;
  try {
    page = std::make_unique<tools::PageProcess>(0);
  } catch (const vo::Error& error) {
    GTEST_SKIP() << error.what();
  }
  const support::LocalUrl url(page->url());
  const support::Connection viewer(url.port);
  page->keep("stage", "{\"a\": 1}");
  viewer.send(support::request_text("GET", "/events" + url.query, "Host: " + url.host() + "\r\n"));
  viewer.read_until("event: stage\ndata: {\"a\": 1}");
  page->keep("end", "{}");
  page.reset();
  EXPECT_THAT(viewer.read_until(""), HasSubstr("event: end\ndata: {}\n\n"));
  EXPECT_THROW(support::Connection{url.port}, std::runtime_error);
}

}  // namespace
