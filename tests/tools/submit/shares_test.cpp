#include "tools/submit/shares.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tools/cli/task_share.h"

namespace {

using Shares = std::vector<std::size_t>;
using support::error_text;
using testing::ElementsAre;
using testing::HasSubstr;

/// Some of the numbers 1 to `count`, the same in every run.
Shares some_of(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  Shares shares;
  for (std::size_t share = 1; share <= count; ++share) {
    if (random() % 3 != 0) {
      shares.push_back(share);
    }
  }
  return shares;
}

TEST(Shares, AreReadFromTheSyntaxOfArrays) {
  EXPECT_THAT(tools::parse_shares("1,3-5\n"), ElementsAre(1U, 3U, 4U, 5U));
  EXPECT_THAT(tools::parse_shares("4,2-3,3"), ElementsAre(2U, 3U, 4U));
  EXPECT_THAT(tools::parse_shares(" \n"), ElementsAre());
}

TEST(Shares, ThatAreWrittenAreReadBack) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Shares shares = some_of(seed, seed);
    EXPECT_EQ(tools::parse_shares(tools::array_text(shares)), shares);
  }
}

TEST(Shares, ThatAreNoneAreNamed) {
  for (const char* text : {"a", "1,,2", "1-", "-1", "1 2", "1%4", "1:2"}) {
    EXPECT_THAT(error_text([&] { tools::parse_shares(text); }),
                HasSubstr("is no number of a share"))
        << text;
  }
  for (const char* text : {"5-3", "1-18446744073709551615"}) {
    EXPECT_THAT(error_text([&] { tools::parse_shares(text); }), HasSubstr("is no range of shares"))
        << text;
  }
}

TEST(ArrayChunks, HoldEveryShareOnceBelowTheGreatestIndex) {
  for (const std::size_t limit : {2U, 3U, 7U, 1001U, 100000U}) {
    for (const std::size_t count : {0U, 1U, 6U, 7U, 100U, 2500U}) {
      const Shares shares = some_of(count, static_cast<unsigned>(limit));
      Shares found;
      for (const tools::ArrayChunk& chunk : tools::chunk_shares(shares, limit)) {
        const Shares own = chunk.shares();
        found.insert(found.end(), own.begin(), own.end());
        EXPECT_GE(chunk.indices.front(), 1U);
        EXPECT_LT(chunk.indices.back(), limit);
        EXPECT_LE(chunk.indices.size(), 1000U);
      }
      EXPECT_EQ(found, shares) << limit << ", " << count;
    }
  }
}

TEST(ArrayChunks, NeedRoomForATask) {
  EXPECT_THAT(error_text([] { tools::chunk_shares({1}, 1); }), HasSubstr("MaxArraySize is 1"));
}

}  // namespace
