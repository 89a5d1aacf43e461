#include "tools/cameras/newest_frames.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "vo/core/error.h"

namespace {

using support::error_kind;
using support::error_text;
using testing::HasSubstr;
using tools::LiveCamera;
using tools::NewestFrames;

/// A camera that gives frames with the stamps 1, 2, ... as fast as they are taken, and then ends.
LiveCamera counting_camera(int frames, std::size_t missed = 0) {
  const auto count = std::make_shared<int>(0);
  return {.device = "counter",
          .camera = {},
          .next = [=](const std::function<bool()>& is_stopped) -> std::optional<vo::RgbdFrame> {
            if (is_stopped() || *count == frames) {
              return std::nullopt;
            }
            return vo::RgbdFrame{static_cast<double>(++*count), {}, {}};
          },
          .missed = [=] { return missed; },
          .notes = {}};
}

/// The same camera, which then fails.
LiveCamera failing_camera(int frames) {
  LiveCamera camera = counting_camera(frames);
  camera.next = [next = camera.next](const std::function<bool()>& is_stopped) {
    std::optional<vo::RgbdFrame> frame = next(is_stopped);
    if (!frame) {
      vo::fail_as(vo::ErrorKind::temporary, "counter: was unplugged");
    }
    return frame;
  };
  return camera;
}

std::vector<double> stamps_of(NewestFrames& frames, std::chrono::milliseconds pause) {
  std::vector<double> stamps;
  while (const std::optional<vo::RgbdFrame> frame = frames.next()) {
    stamps.push_back(frame->timestamp);
    std::this_thread::sleep_for(pause);
  }
  return stamps;
}

TEST(NewestFrames, ThatNobodyWaitsForAreDroppedAndCounted) {
  NewestFrames frames(counting_camera(1000, 7), 0, [] { return false; });
  const std::vector<double> stamps = stamps_of(frames, std::chrono::milliseconds(2));
  EXPECT_TRUE(std::is_sorted(stamps.begin(), stamps.end(), std::less_equal<>()));
  EXPECT_EQ(stamps.back(), 1000) << "the last is never dropped";
  EXPECT_LT(stamps.size(), 1000U);
  const NewestFrames::End end = frames.finish();
  EXPECT_EQ(stamps.size() + end.dropped, 1007U);
  EXPECT_EQ(end.failure, "");
}

TEST(NewestFrames, AreAsManyAsAreWanted) {
  NewestFrames frames(counting_camera(1 << 30), 3, [] { return false; });
  EXPECT_EQ(stamps_of(frames, std::chrono::milliseconds(1)).size(), 3U);
  EXPECT_GT(frames.finish().dropped, 0U);
}

TEST(NewestFrames, EndWhenTheUserSaysSo) {
  std::atomic<bool> is_stopped = false;
  NewestFrames frames(counting_camera(1 << 30), 0, [&] { return is_stopped.load(); });
  ASSERT_TRUE(frames.next().has_value());
  is_stopped = true;
  EXPECT_LE(stamps_of(frames, std::chrono::milliseconds(0)).size(), 1U) << "that was there already";
}

TEST(NewestFrames, OfACameraThatFailsAreKept) {
  NewestFrames frames(failing_camera(3), 0, [] { return false; });
  EXPECT_EQ(stamps_of(frames, std::chrono::milliseconds(0)).back(), 3);
  EXPECT_EQ(frames.finish().failure, "counter: was unplugged");
}

TEST(NewestFrames, ThatNeverCameAreAnError) {
  NewestFrames failing(failing_camera(0), 0, [] { return false; });
  EXPECT_FALSE(failing.next().has_value());
  EXPECT_EQ(error_kind([&] { failing.finish(); }), vo::ErrorKind::temporary);
  NewestFrames stopped(counting_camera(9), 0, [] { return true; });
  EXPECT_FALSE(stopped.next().has_value());
  EXPECT_THAT(error_text([&] { stopped.finish(); }), HasSubstr("counter: has given no frame"));
}

}  // namespace
