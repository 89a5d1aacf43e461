#include "vo/geometry/associate.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vo {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

std::vector<double> random_stamps(std::size_t count, double span, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, span);
  std::vector<double> stamps(count);
  std::generate(stamps.begin(), stamps.end(), [&] { return uniform(random); });
  std::sort(stamps.begin(), stamps.end());
  return stamps;
}

/// The definition: again and again the closest pair of unused stamps.
Pairs associate_by_definition(const std::vector<double>& a, const std::vector<double>& b,
                              double max_difference) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      candidates.emplace_back(std::abs(a[i] - b[j]), i, j);
    }
  }
  Pairs pairs;
  while (!candidates.empty()) {
    const auto [difference, i, j] = *std::min_element(candidates.begin(), candidates.end());
    if (difference >= max_difference) {
      break;
    }
    pairs.emplace_back(i, j);
    std::erase_if(candidates, [i = i, j = j](const auto& candidate) {
      return std::get<1>(candidate) == i || std::get<2>(candidate) == j;
    });
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(Associate, TakesTheClosestPairFirst) {
  const std::vector<double> a = {0.0, 1.0};
  const std::vector<double> b = {0.9, 2.0};
  EXPECT_THAT(associate(a, b, 1.5), ElementsAre(Pair(1, 0)));
}

TEST(Associate, TakesTheEarlierOfTwoEquallyClosePairs) {
  const std::vector<double> a = {1.0};
  const std::vector<double> b = {0.5, 1.5};
  EXPECT_THAT(associate(a, b, 1), ElementsAre(Pair(0, 0)));
}

TEST(Associate, LeavesOutPairsAtTheLimit) {
  const std::vector<double> a = {0.0, 1.0};
  const std::vector<double> b = {0.25, 1.5};
  EXPECT_THAT(associate(a, b, 0.5), ElementsAre(Pair(0, 0)));
}

TEST(Associate, TakesEqualStampsWhateverTheLimit) {
  const std::vector<double> a = {0.0, 1.0, 2.0};
  const std::vector<double> b = {0.0, 1.5, 2.0};
  EXPECT_THAT(associate(a, b, 0), ElementsAre(Pair(0, 0), Pair(2, 2)));
}

TEST(Associate, FindsNothingInNothing) {
  const std::vector<double> a = {0.0, 1.0};
  EXPECT_THAT(associate(a, {}, 1), IsEmpty());
  EXPECT_THAT(associate({}, a, 1), IsEmpty());
}

TEST(Associate, AgreesWithTheDefinitionWhereManyPairsAreEquallyClose) {
  std::mt19937 random(2);
  std::bernoulli_distribution is_there(0.6);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> a;
    std::vector<double> b;
    for (int stamp = 0; stamp < 40; ++stamp) {
      if (is_there(random)) {
        a.push_back(stamp);
      }
      if (is_there(random)) {
        b.push_back(stamp + 0.5 * (trial % 2));
      }
    }
    for (const double max_difference : {0.6, 2.0, 7.0}) {
      EXPECT_EQ(associate(a, b, max_difference), associate_by_definition(a, b, max_difference));
    }
  }
}

TEST(Associate, TakesNoMorePairsForAMillionStampsCloseToEachOther) {
  std::vector<double> a(1'000'000);
  std::vector<double> b(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = 1e-8 * static_cast<double>(i);
    b[i] = a[i] + 0.3e-8;
  }
  const Pairs pairs = associate(a, b, 0.02);  // of 1e12 pairs within the limit
  ASSERT_EQ(pairs.size(), a.size());
  EXPECT_TRUE(
      std::all_of(pairs.begin(), pairs.end(), [](const auto& p) { return p.first == p.second; }));
}

TEST(Associate, AgreesWithTheDefinitionOnRandomStamps) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<double> a = random_stamps(30, 1, random);
    const std::vector<double> b = random_stamps(50, 1, random);
    const double max_difference = trial % 2 == 0 ? 0.02 : 0.3;  // s
    EXPECT_EQ(associate(a, b, max_difference), associate_by_definition(a, b, max_difference));
  }
}

TEST(Associate, TakesAMillionStampsInOneGo) {
  std::vector<double> a;
  std::vector<double> b;
  for (int i = 0; i < 1'000'000; ++i) {
    a.push_back(i * 0.01);
    b.push_back(i * 0.01 + 0.001);
  }
  const Pairs pairs = associate(a, b, 0.02);
  ASSERT_EQ(pairs.size(), a.size());
  EXPECT_TRUE(std::all_of(pairs.begin(), pairs.end(),
                          [](const auto& pair) { return pair.first == pair.second; }));
}

}  // namespace
}  // namespace vo
