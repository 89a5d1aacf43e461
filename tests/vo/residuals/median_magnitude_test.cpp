#include "vo/residuals/median_magnitude.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "vo/core/hash.h"
#include "vo/core/median.h"

namespace {

/// Returns magnitudes over many orders, some of them equal, some 0.
std::vector<float> magnitudes(std::size_t count) {
  std::vector<float> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = vo::random_uniform({count, i});
    result.push_back(share < 0.1 ? 0 : static_cast<float>(share * share * share));
    if (share > 0.9) {
      result.back() = 0.25F;
    }
  }
  return result;
}

TEST(MedianMagnitude, IsThatOfTheOrderedMagnitudes) {
  for (const std::size_t count : {1U, 2U, 3U, 10U, 63U, 64U, 65U, 600U, 663U}) {
    const std::vector<float> values = magnitudes(count);
    EXPECT_EQ(vo::median_magnitude(values), vo::upper_median(values)) << count;
    EXPECT_EQ(vo::robust_sigma_of(values), vo::robust_sigma(values)) << count;
  }
}

TEST(MedianMagnitude, IsZeroWithoutMagnitudes) {
  EXPECT_EQ(vo::median_magnitude({}), 0);
}

}  // namespace
