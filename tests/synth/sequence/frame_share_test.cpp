#include "synth/sequence/frame_share.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"

namespace tools {
namespace {

using support::error_kind;
using testing::ElementsAre;

synth::FrameShare share_of(const std::string& frames, const std::string& shard) {
  synth::FrameShare share;
  synth::parse_frames(frames, share);
  synth::parse_shard(shard, share);
  return share;
}

TEST(FrameShare, AnOpenEndMeansTheSequences) {
  EXPECT_THAT(synth::frames_of({}, 3), ElementsAre(0, 1, 2));
  EXPECT_THAT(synth::frames_of(share_of("1:3", "1/1"), 4), ElementsAre(1, 2));
  EXPECT_THAT(synth::frames_of(share_of("2:", "1/1"), 4), ElementsAre(2, 3));
  EXPECT_THAT(synth::frames_of(share_of(":1", "1/1"), 4), ElementsAre(0));
}

TEST(FrameShare, ShardsMakeUpTheRangeWhateverTheirNumber) {
  for (const std::string shards : {"1", "2", "3", "7", "12"}) {
    std::vector<std::size_t> all;
    for (int k = 1; k <= std::stoi(shards); ++k) {
      const auto frames = synth::frames_of(share_of("2:11", std::to_string(k) + "/" + shards), 20);
      all.insert(all.end(), frames.begin(), frames.end());
    }
    EXPECT_THAT(all, ElementsAre(2, 3, 4, 5, 6, 7, 8, 9, 10)) << shards;
  }
}

TEST(FrameShare, RefusesWhatIsNoShare) {
  for (const char* text : {"", "3", "3:3", "4:3", "a:b", "-1:3", "1:2:3", "1/2"}) {
    synth::FrameShare share;
    EXPECT_EQ(error_kind([&] { synth::parse_frames(text, share); }), vo::ErrorKind::usage) << text;
  }
  for (const char* text : {"", "1", "0/4", "5/4", "/4", "1/", "1/0", "1:4", "x/4"}) {
    synth::FrameShare share;
    EXPECT_EQ(error_kind([&] { synth::parse_shard(text, share); }), vo::ErrorKind::usage) << text;
  }
  EXPECT_EQ(error_kind([] { synth::frames_of(share_of("2:5", "1/1"), 4); }), vo::ErrorKind::usage);
  EXPECT_EQ(error_kind([] { synth::frames_of(share_of("4:", "1/1"), 4); }), vo::ErrorKind::usage);
}

}  // namespace
}  // namespace tools
