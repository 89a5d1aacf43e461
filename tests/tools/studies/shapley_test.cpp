#include "tools/studies/shapley.h"

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

namespace {

TEST(Shapley, IndependentContributionsAreThemselves) {
  const std::vector<double> parts{1, 2, 4};
  const std::vector<double> shares = tools::shapley_values(3, [&](std::uint32_t set) {
    double sum = 10;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      sum += (set >> i & 1) != 0 ? parts[i] : 0;
    }
    return sum;
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_NEAR(shares[i], parts[i], 1e-12);
  }
}

TEST(Shapley, TheGloveGameHasItsKnownValue) {
  const auto pair_of_gloves = [](std::uint32_t set) {  // one left, two right ones
    return (set & 1) != 0 && (set & 6) != 0 ? 1.0 : 0.0;
  };
  const std::vector<double> shares = tools::shapley_values(3, pair_of_gloves);
  EXPECT_NEAR(shares[0], 4.0 / 6, 1e-12);
  EXPECT_NEAR(shares[1], 1.0 / 6, 1e-12);
  EXPECT_NEAR(shares[2], 1.0 / 6, 1e-12);
}

TEST(Shapley, SharesSumToTheWholeLessNone) {
  const auto value = [](std::uint32_t set) { return std::sqrt(3.0 + std::popcount(set) * set); };
  const std::vector<double> shares = tools::shapley_values(5, value);
  double sum = 0;
  for (const double share : shares) {
    sum += share;
  }
  EXPECT_NEAR(sum, value(31) - value(0), 1e-12);
}

}  // namespace
