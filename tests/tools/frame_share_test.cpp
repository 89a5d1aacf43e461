#include "tools/pipeline/frame_share.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace tools {
namespace {

using support::error_kind;
using testing::ElementsAre;

FrameShare share_of(const std::string& frames, const std::string& shard) {
  FrameShare share;
  parse_frames(frames, share);
  parse_shard(shard, share);
  return share;
}

TEST(FrameShare, AnOpenEndMeansTheSequences) {
  EXPECT_THAT(frames_of({}, 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(frames_of(share_of("1:3", "1/1"), 4), ElementsAre(1, 2));
  EXPECT_THAT(frames_of(share_of("2:", "1/1"), 4), ElementsAre(2, 3));
  EXPECT_THAT(frames_of(share_of(":1", "1/1"), 4), ElementsAre(0));
}

TEST(FrameShare, ShardsMakeUpTheRangeWhateverTheirNumber) {
  for (const std::string shards : {"1", "2", "3", "7", "12"}) {
    std::vector<std::size_t> all;
    for (int k = 1; k <= std::stoi(shards); ++k) {
      const auto frames = frames_of(share_of("2:11", std::to_string(k) + "/" + shards), 20);
      all.insert(all.end(), frames.begin(), frames.end());
    }
    EXPECT_THAT(all, ElementsAre(2, 3, 4, 5, 6, 7, 8, 9, 10)) << shards;
  }
}

TEST(FrameShare, RefusesWhatIsNoShare) {
  for (const char* text : {"", "3", "3:3", "4:3", "a:b", "-1:3", "1:2:3", "1/2"}) {
    FrameShare share;
    EXPECT_EQ(error_kind([&] { parse_frames(text, share); }), vo::ErrorKind::usage) << text;
  }
  for (const char* text : {"", "1", "0/4", "5/4", "/4", "1/", "1/0", "1:4", "x/4"}) {
    FrameShare share;
    EXPECT_EQ(error_kind([&] { parse_shard(text, share); }), vo::ErrorKind::usage) << text;
  }
  EXPECT_EQ(error_kind([] { frames_of(share_of("2:5", "1/1"), 4); }), vo::ErrorKind::usage);
  EXPECT_EQ(error_kind([] { frames_of(share_of("4:", "1/1"), 4); }), vo::ErrorKind::usage);
}

}  // namespace
}  // namespace tools
