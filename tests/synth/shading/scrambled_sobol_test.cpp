#include "synth/shading/scrambled_sobol.h"

#include <vector>

#include <gtest/gtest.h>

namespace synth {
namespace {

TEST(ScrambledSobol, EveryBoxOfEqualAreaHoldsOnePointWhateverItsShape) {
  constexpr int kBits = 8;
  for (const std::uint64_t bits : {0ULL, 1ULL, 0x123456789abcdefULL, ~0ULL}) {
    for (int columns = 0; columns <= kBits; ++columns) {
      std::vector<int> counts(1U << kBits);
      for (int n = 0; n < 1 << kBits; ++n) {
        const Eigen::Vector2f point = scrambled_sobol(bits, n);
        const auto x = static_cast<unsigned>(point.x() * static_cast<float>(1U << columns));
        const auto y =
            static_cast<unsigned>(point.y() * static_cast<float>(1U << (kBits - columns)));
        ++counts.at(y << columns | x);
      }
      EXPECT_EQ(counts, std::vector<int>(1U << kBits, 1)) << columns << " bits of columns";
    }
  }
}

TEST(ScrambledSobol, SequencesOfOtherBitsAreIndependent) {
  constexpr int kCount = 4096;
  double sum = 0;
  for (int n = 0; n < kCount; ++n) {
    sum +=
        (scrambled_sobol(vo::mixed(7), n).x() - 0.5) * (scrambled_sobol(vo::mixed(8), n).x() - 0.5);
  }
  EXPECT_NEAR(sum / kCount, 0, 4.0 / 12 / 64);  // 4 sigma of independent numbers, each of 1/12
}

}  // namespace
}  // namespace synth
