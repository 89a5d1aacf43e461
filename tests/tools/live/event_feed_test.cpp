#include "tools/live/event_feed.h"

#include <thread>

#include <gtest/gtest.h>

#include "tools/live/latest_slot.h"
#include "tools/live/pause_gate.h"

namespace {

using std::chrono::milliseconds;
using tools::EventFeed;

constexpr milliseconds kNoPatience(0);

TEST(EventFeed, GivesEveryKeptEventToEachViewer) {
  EventFeed feed;
  EventFeed::Place early;
  feed.keep("frame", "1");
  EXPECT_EQ(feed.read(early, kNoPatience), "event: frame\ndata: 1\n\n");
  feed.keep("frame", "2");
  EventFeed::Place late;
  EXPECT_EQ(feed.read(late, kNoPatience), "event: frame\ndata: 1\n\nevent: frame\ndata: 2\n\n");
  EXPECT_EQ(feed.read(early, kNoPatience), "event: frame\ndata: 2\n\n");
  EXPECT_EQ(feed.read(early, kNoPatience), "");
}

TEST(EventFeed, GivesTheLastOfWhatIsReplacedAndGivesItOnce) {
  EventFeed feed;
  EventFeed::Place place;
  feed.replace("pictures", "1");
  feed.replace("pictures", "2");
  EXPECT_EQ(feed.read(place, kNoPatience), "event: pictures\ndata: 2\n\n");
  EXPECT_EQ(feed.read(place, kNoPatience), "");
}

TEST(EventFeed, GivesWhatIsReplacedAfterAllThatItMayReferTo) {
  EventFeed feed;
  EventFeed::Place place;
  const std::string frame(1000, 'x');
  for (int i = 0; i < 1000; ++i) {
    feed.keep("frame", frame);
  }
  feed.replace("pictures", "p");
  std::string all;
  int readings = 0;
  for (std::string text = feed.read(place, kNoPatience); !text.empty();
       text = feed.read(place, kNoPatience)) {
    EXPECT_LT(text.size(), 300'000U);
    all += text;
    ++readings;
  }
  EXPECT_GT(readings, 3);
  EXPECT_EQ(all.find("event: pictures"),
            1000 * std::string("event: frame\ndata: \n\n").size() + 1000 * frame.size());
}

/// A page reads no further than the end, so that it would miss what comes after it.
TEST(EventFeed, EndsAfterTheLastPicturesAlsoForWhoComesLater) {
  EventFeed feed;
  EventFeed::Place early;
  feed.keep("frame", "1");
  feed.replace("pictures", "p");
  feed.end("end", "done");
  const std::string all =
      "event: frame\ndata: 1\n\nevent: pictures\ndata: p\n\nevent: end\ndata: done\n\n";
  EXPECT_EQ(feed.read(early, kNoPatience), all);
  EXPECT_EQ(feed.read(early, kNoPatience), "") << "once";
  EventFeed::Place late;
  EXPECT_EQ(feed.read(late, kNoPatience), all);
}

TEST(EventFeed, IsOverWhenItIsClosedAndAllHasBeenRead) {
  EventFeed feed;
  EventFeed::Place place;
  feed.end("end", "1");
  EXPECT_FALSE(feed.is_over(place));
  feed.close();
  EXPECT_FALSE(feed.is_over(place));
  feed.read(place, kNoPatience);
  EXPECT_TRUE(feed.is_over(place));
}

TEST(PauseGate, LetsAsManyFramesPassAsStepsWereAsked) {
  tools::PauseGate gate;
  int waited = 0;
  const auto waiting = [&] {
    if (++waited == 3) {
      throw std::runtime_error("the run would wait");
    }
  };
  gate.pass(waiting);
  gate.step();
  gate.step();
  gate.pass(waiting);
  gate.pass(waiting);
  EXPECT_EQ(waited, 0);
  EXPECT_TRUE(gate.is_paused());
  EXPECT_THROW(gate.pass(waiting), std::runtime_error);
  gate.resume();
  gate.pass(waiting);
  EXPECT_EQ(waited, 3);
}

TEST(PauseGate, IsOpenedByAnotherThread) {
  tools::PauseGate gate;
  gate.pause();
  std::thread other([&] { gate.resume(); });
  gate.pass({});
  other.join();
  EXPECT_FALSE(gate.is_paused());
}

TEST(LatestSlot, HasWhatWasPutLast) {
  tools::LatestSlot<int> slot;
  EXPECT_FALSE(slot.is_wanted()) << "nobody takes";
  slot.put(1);
  slot.put(2);
  EXPECT_EQ(slot.take(), 2);
  slot.close();
  EXPECT_EQ(slot.take(), std::nullopt);
}

TEST(LatestSlot, IsWantedWhileSomebodyWaits) {
  tools::LatestSlot<int> slot;
  std::optional<int> taken;
  std::thread taker([&] { taken = slot.take(); });
  slot.wait_until_wanted({});
  EXPECT_TRUE(slot.is_wanted());
  slot.put(7);
  taker.join();
  EXPECT_EQ(taken, 7);
  EXPECT_FALSE(slot.is_wanted());
}

}  // namespace
