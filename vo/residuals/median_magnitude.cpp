#include "vo/residuals/median_magnitude.h"

#include <bit>
#include <cstddef>
#include <limits>

#include "vo/core/instruction_set.h"

namespace vo {
namespace {

/// Returns how many magnitudes are at most that of these bits: bits of floats that are at least 0
/// are in the order of the floats.
EDVO_INLINE int count_up_to(int bits, std::span<const float> magnitudes) {
  int count = 0;
  for (const float magnitude : magnitudes) {
    count += std::bit_cast<int>(magnitude) <= bits ? 1 : 0;
  }
  return count;
}

/// Halves the range that the median lies in until one value is left, which takes no branch that
/// depends on the values.
EDVO_INLINE float find_median(std::span<const float> magnitudes) {
  const int wanted = static_cast<int>(magnitudes.size() / 2) + 1;
  int low = 0;
  int high = std::bit_cast<int>(std::numeric_limits<float>::infinity());
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (count_up_to(middle, magnitudes) >= wanted) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::bit_cast<float>(low);
}

float find_median_baseline(std::span<const float> magnitudes) {
  return find_median(magnitudes);
}

EDVO_TARGET_AVX2 float find_median_avx2(std::span<const float> magnitudes) {
  return find_median(magnitudes);
}

EDVO_TARGET_AVX512 float find_median_avx512(std::span<const float> magnitudes) {
  return find_median(magnitudes);
}

}  // namespace

float median_magnitude(std::span<const float> magnitudes) {
  if (magnitudes.empty()) {
    return 0;
  }
  const InstructionSet set = available_instruction_set();
  const auto find = version_for(set, find_median_baseline, find_median_avx2, find_median_avx512);
  return find(magnitudes);
}

}  // namespace vo
