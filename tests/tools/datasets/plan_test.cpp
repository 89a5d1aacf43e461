#include "tools/datasets/plan.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace {

/// A plan of sequences with so many frames, cut into parts of at most `longest`.
tools::DatasetPlan plan_of(const std::vector<std::size_t>& frames, std::size_t longest) {
  tools::DatasetPlan plan{.frames = frames};
  for (std::size_t sequence = 0; sequence < frames.size(); ++sequence) {
    std::size_t number = 0;
    for (std::size_t first = 0; first < frames[sequence]; first += longest) {
      plan.parts.push_back(
          {sequence, number++, first, std::min(first + longest, frames[sequence])});
    }
  }
  return plan;
}

std::size_t frames_of(const tools::DatasetPlan& plan, const std::vector<std::size_t>& share) {
  std::size_t frames = 0;
  for (const std::size_t part : share) {
    frames += plan.parts[part].end - plan.parts[part].first;
  }
  return frames;
}

TEST(ShareOfParts, CoversEveryPartOnceInOrder) {
  const tools::DatasetPlan plan = plan_of({7, 0, 30, 1, 12, 100, 3}, 5);
  for (std::size_t shares = 1; shares <= 60; ++shares) {
    std::vector<std::size_t> all;
    for (std::size_t k = 1; k <= shares; ++k) {
      const std::vector<std::size_t> share = tools::share_of_parts(plan, k, shares);
      all.insert(all.end(), share.begin(), share.end());
    }
    ASSERT_EQ(all.size(), plan.parts.size()) << shares;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i], i) << shares;
    }
  }
}

/// A share ends where a part does: its frames are within one part of an equal share at each end.
TEST(ShareOfParts, SharesFramesEvenly) {
  constexpr std::size_t kLongest = 4;
  const tools::DatasetPlan plan = plan_of({40, 9, 77, 3, 18}, kLongest);
  for (std::size_t shares = 1; shares <= 20; ++shares) {
    const double equal = static_cast<double>(plan.frame_count()) / static_cast<double>(shares);
    for (std::size_t k = 1; k <= shares; ++k) {
      const auto frames =
          static_cast<double>(frames_of(plan, tools::share_of_parts(plan, k, shares)));
      EXPECT_LE(std::abs(frames - equal), kLongest) << k << " of " << shares;
    }
  }
}

/// What several cameras take is more frames in the same parts: whose they are stays as it was.
TEST(ShareOfParts, CountsTheFramesOfAllCamerasAlike) {
  const tools::DatasetPlan one = plan_of({40, 9, 77, 3, 18}, 4);
  tools::DatasetPlan six = one;
  six.cameras = 6;
  EXPECT_EQ(one.frame_count(), 147U);
  EXPECT_EQ(six.frame_count(), 6 * 147U);
  EXPECT_EQ(six.sequence_count(), 5U);
  for (std::size_t shares = 1; shares <= 20; ++shares) {
    EXPECT_EQ(tools::shares_by_part(six, shares), tools::shares_by_part(one, shares)) << shares;
  }
}

TEST(ShareOfParts, IsEmptyWhereNothingIsMade) {
  EXPECT_TRUE(tools::share_of_parts(plan_of({0, 0}, 5), 1, 2).empty());
}

}  // namespace
