#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr int kWidth = 400;
constexpr double kCount = 400.0 * 400.0;

/// The mean of `value(u, v)` over a square of places.
template <typename Value>
double mean_over_places(const Value& value) {
  double sum = 0;
  for (int v = 0; v < kWidth; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      sum += value(u, v);
    }
  }
  return sum / kCount;
}

TEST(RandomField, HasNormalNumbersWithTheMomentsOfANormalDistribution) {
  const vo::RandomField field(7, 1, 2);
  const std::array<double, 4> moments = {0, 1, 0, 3};
  const std::array<double, 4> variances = {1, 2, 15, 96};  // of the sample moments, times count
  for (int power = 1; power <= 4; ++power) {
    const double moment =
        mean_over_places([&](int u, int v) { return std::pow(field.normal(u, v), power); });
    const auto i = static_cast<std::size_t>(power - 1);
    EXPECT_NEAR(moment, moments[i], 4 * std::sqrt(variances[i] / kCount)) << "power " << power;
  }
}

TEST(RandomField, HasUniformNumbersInEachTenth) {
  const vo::RandomField field(7, 1, 2);
  std::array<int, 10> counts{};
  mean_over_places([&](int u, int v) {
    return ++counts.at(static_cast<std::size_t>(10 * field.uniform(u, v)));
  });
  for (const int count : counts) {
    EXPECT_NEAR(count, kCount / 10, 4 * std::sqrt(kCount * 0.09));
  }
}

/// Of normal numbers of two fields, the second one at a shifted place.
double correlation(const vo::RandomField& a, const vo::RandomField& b, int du, int dv, int index) {
  return mean_over_places(
      [&](int u, int v) { return a.normal(u, v) * b.normal(u + du, v + dv, index); });
}

TEST(RandomField, IsIndependentBetweenPlacesIndicesSeedsPurposesAndFrames) {
  const vo::RandomField field(7, 1, 2);
  const double bound = 4 / std::sqrt(kCount);
  EXPECT_NEAR(correlation(field, field, 1, 0, 0), 0, bound);
  EXPECT_NEAR(correlation(field, field, 0, 1, 0), 0, bound);
  EXPECT_NEAR(correlation(field, field, 0, 0, 1), 0, bound);
  EXPECT_NEAR(correlation(field, {8, 1, 2}, 0, 0, 0), 0, bound);
  EXPECT_NEAR(correlation(field, {7, 2, 2}, 0, 0, 0), 0, bound);
  EXPECT_NEAR(correlation(field, {7, 1, 3}, 0, 0, 0), 0, bound);
  EXPECT_NEAR(correlation(field, field, 0, 0, 0), 1, 4 * std::sqrt(2 / kCount));
}

}  // namespace
}  // namespace synth
