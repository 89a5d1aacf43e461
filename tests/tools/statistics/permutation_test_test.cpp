#include "tools/statistics/permutation_test.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "tools/statistics/significance.h"
#include "vo/core/random.h"

namespace {

using Values = std::vector<double>;

TEST(PermutationTest, DarwinsMaizeHasThePValueThatFisherCounted) {
  // Fisher, The Design of Experiments (1935), section 21: 1726 of 32768 ways, in eighths of an
  // inch.
  const Values differences{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
  EXPECT_NEAR(tools::sign_flip_p_value(Values(15, 0.0), differences, 1), 1726.0 / 32768, 1e-12);
}

TEST(PermutationTest, EqualDifferencesHaveThePValueOfTheSignTest) {
  for (const int pairs : {2, 3, 5, 12}) {
    const Values before(static_cast<std::size_t>(pairs), 5.0);
    const Values after(static_cast<std::size_t>(pairs), 6.0);
    EXPECT_NEAR(tools::sign_flip_p_value(before, after, 1), std::exp2(1 - pairs), 1e-12) << pairs;
    EXPECT_EQ(tools::sign_flip_p_value(before, before, 1), 1);
  }
}

TEST(PermutationTest, TwoValuesAreTestedAsFishersTestDoes) {
  const Values before{1, 1, 1, 1, 1, 1, 1, 0, 0};
  const Values after{1, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_NEAR(tools::permutation_p_value(before, after, 1), tools::fisher_p_value({7, 9}, {1, 9}),
              1e-12);
  EXPECT_NEAR(tools::permutation_p_value(Values{5, 5}, Values{6, 6}, 1), 2.0 / 6, 1e-12);
}

/// Counts by visiting every way to divide the values.
double counted_p_value(const Values& before, const Values& after) {
  Values all = before;
  all.insert(all.end(), after.begin(), after.end());
  const double center = std::accumulate(all.begin(), all.end(), 0.0) *
                        static_cast<double>(before.size()) / static_cast<double>(all.size());
  const auto distance = [&](double sum) { return std::abs(sum - center); };
  const double seen = distance(std::accumulate(before.begin(), before.end(), 0.0)) - 1e-9;
  std::vector<bool> chosen(all.size(), false);
  std::fill_n(chosen.begin(), before.size(), true);
  int ways = 0;
  int as_far = 0;
  do {
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      sum += chosen[i] ? all[i] : 0;
    }
    ++ways;
    as_far += distance(sum) >= seen ? 1 : 0;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return static_cast<double>(as_far) / ways;
}

TEST(PermutationTest, EveryDivisionIsCounted) {
  vo::Random random(1);
  for (int i = 0; i < 50; ++i) {
    Values before(4);
    Values after(6);
    std::generate(before.begin(), before.end(), [&] { return random.below(9) - 3; });
    std::generate(after.begin(), after.end(), [&] { return random.below(9); });
    EXPECT_NEAR(tools::permutation_p_value(before, after, 1), counted_p_value(before, after),
                1e-12);
  }
}

TEST(PermutationTest, ContinuousValuesAreCountedToAThousandthOfTheirRange) {
  vo::Random random(2);
  for (int i = 0; i < 20; ++i) {
    Values before(6);
    Values after(6);
    std::generate(before.begin(), before.end(), [&] { return random.normal(); });
    std::generate(after.begin(), after.end(), [&] { return random.normal() + 1; });
    EXPECT_NEAR(tools::permutation_p_value(before, after, 0), counted_p_value(before, after), 0.01);
  }
}

}  // namespace
