#include "vo/edges/canny.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__x86_64__)
#define EDVO_HAS_MASKS
#include <immintrin.h>
#endif

#include "vo/core/pixel_bits.h"

namespace vo {
namespace {

/// Squared gradient magnitudes that a pixel must exceed.
struct SquaredThresholds {
  int weak = 0;
  int strong = 0;
};

SquaredThresholds squared_thresholds(double weak, double strong) {
  static constexpr double kMax = 32767;
  const auto squared = [](double threshold) {
    const double clamped = std::min(threshold, kMax);
    return static_cast<int>(std::floor(clamped > 0 ? clamped * clamped : clamped));
  };
  return {squared(weak), squared(strong)};
}

/// Squared gradient magnitudes of three rows and the gradient of the middle one, from column u on.
struct Neighbourhood {
  const int* above;
  const int* here;
  const int* below;
  const std::int16_t* dx;
  const std::int16_t* dy;

  EDVO_INLINE Neighbourhood(const std::array<const GradientRow*, 3>& rows, int u)
      : above(rows[0]->squared() + u),
        here(rows[1]->squared() + u),
        below(rows[2]->squared() + u),
        dx(rows[1]->dx() + u),
        dy(rows[1]->dy() + u) {}
};

constexpr int kTanShift = 15;
constexpr int kTan22 = 13573;  // tan(22.5 deg) 2^15

/// Marks the maxima across the edge in 64 pixels. The gradient's direction is horizontal below 22.5
/// deg, vertical above 67.5 deg, else one of the diagonals.
EDVO_INLINE void suppress(const Neighbourhood& at, SquaredThresholds thresholds,
                          uchar* __restrict edges, uchar* __restrict strong) {
  for (int u = 0; u < kPixelsPerWord; ++u) {
    const int gx = at.dx[u];
    const int gy = at.dy[u];
    const int x = (gx ^ (gx >> 31)) - (gx >> 31);  // |gx|, in a form that is vectorized
    const int y = ((gy ^ (gy >> 31)) - (gy >> 31)) << kTanShift;
    const int horizontal = y < x * kTan22 ? -1 : 0;
    const int vertical = y > x * kTan22 + (x << (kTanShift + 1)) ? -1 : 0;
    const int diagonal = ~(horizontal | vertical);
    const int falling = diagonal & ((gx ^ gy) >> 31);
    const int rising = diagonal & ~falling;
    const int before = (horizontal & at.here[u - 1]) | (vertical & at.above[u]) |
                       (falling & at.above[u + 1]) | (rising & at.above[u - 1]);
    const int after = (horizontal & at.here[u + 1]) | (vertical & at.below[u]) |
                      (falling & at.below[u - 1]) | (rising & at.below[u + 1]);
    const int m = at.here[u];
    const int is_maximum = (m > before ? 1 : 0) & (m > after - 1 - diagonal ? 1 : 0);
    const int is_weak = m > thresholds.weak ? 1 : 0;
    const int is_strong = m > thresholds.strong ? 1 : 0;
    edges[u] = static_cast<uchar>(-(is_maximum & is_weak));
    strong[u] = static_cast<uchar>(-(is_maximum & is_strong));
  }
}

EDVO_INLINE bool any_above(const int* squared, int threshold) {
  int greatest = threshold;
  for (int u = 0; u < kPixelsPerWord; ++u) {
    greatest = squared[u] > greatest ? squared[u] : greatest;
  }
  return greatest > threshold;
}

/// Returns the maxima of 64 pixels; where no gradient is strong enough the search is skipped.
EDVO_INLINE EdgeWord suppressed(const Neighbourhood& at, SquaredThresholds thresholds) {
  if (!any_above(at.here, thresholds.weak)) {
    return {};
  }
  alignas(kPixelsPerWord) std::array<uchar, kPixelsPerWord> edges;
  alignas(kPixelsPerWord) std::array<uchar, kPixelsPerWord> strong;
  suppress(at, thresholds, edges.data(), strong.data());
  return {packed_word(edges.data()), packed_word(strong.data())};
}

#if defined(EDVO_HAS_MASKS)
constexpr int kLanes = 16;
using Lanes = int __attribute__((vector_size(kLanes * sizeof(int))));
using ShortLanes = std::int16_t __attribute__((vector_size(kLanes * sizeof(std::int16_t))));

EDVO_TARGET_AVX512 Lanes load_lanes(const std::int16_t* values) {
  ShortLanes lanes;
  std::memcpy(&lanes, values, sizeof(lanes));
  return __builtin_convertvector(lanes, Lanes);
}

/// Returns a bit for each lane where a > b.
EDVO_TARGET_AVX512 __mmask16 greater(const Lanes& a, const Lanes& b) {
  return _mm512_cmpgt_epi32_mask(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b));
}

/// Returns a bit for each of 16 pixels that is a maximum, by the comparisons of `suppress`.
EDVO_TARGET_AVX512 std::uint64_t maxima(const Neighbourhood& at, int u) {
  const Lanes gx = load_lanes(at.dx + u);
  const Lanes gy = load_lanes(at.dy + u);
  const Lanes x = gx < 0 ? -gx : gx;
  const Lanes y = (gy < 0 ? -gy : gy) << kTanShift;
  const __mmask16 horizontal = greater(x * kTan22, y);
  const __mmask16 vertical = greater(y, x * kTan22 + (x << (kTanShift + 1)));
  const __mmask16 falling = greater(Lanes{}, gx ^ gy);
  __m512i before = _mm512_loadu_si512(at.above + u - 1);
  before = _mm512_mask_loadu_epi32(before, falling, at.above + u + 1);
  before = _mm512_mask_loadu_epi32(before, vertical, at.above + u);
  before = _mm512_mask_loadu_epi32(before, horizontal, at.here + u - 1);
  __m512i after = _mm512_loadu_si512(at.below + u + 1);
  after = _mm512_mask_loadu_epi32(after, falling, at.below + u - 1);
  after = _mm512_mask_loadu_epi32(after, vertical, at.below + u);
  after = _mm512_mask_loadu_epi32(after, horizontal, at.here + u + 1);
  const __m512i m = _mm512_loadu_si512(at.here + u);
  const unsigned ties = _mm512_cmpeq_epi32_mask(m, after) & (horizontal | vertical);
  return _mm512_cmpgt_epi32_mask(m, before) & (_mm512_cmpgt_epi32_mask(m, after) | ties);
}

/// Returns a bit for each of 64 pixels above a threshold.
EDVO_TARGET_AVX512 std::uint64_t above(const int* squared, int threshold) {
  std::uint64_t bits = 0;
  for (int u = 0; u < kPixelsPerWord; u += kLanes) {
    const __m512i lanes = _mm512_loadu_si512(squared + u);
    const std::uint64_t mask = _mm512_cmpgt_epi32_mask(lanes, _mm512_set1_epi32(threshold));
    bits |= mask << u;
  }
  return bits;
}

/// Returns the maxima that `suppressed` returns, by comparisons that give a bit for each pixel.
EDVO_TARGET_AVX512 EdgeWord suppressed_avx512(const Neighbourhood& at,
                                              SquaredThresholds thresholds) {
  EdgeWord word{above(at.here, thresholds.weak), 0};
  if (word.edges != 0) {
    std::uint64_t bits = 0;
    for (int u = 0; u < kPixelsPerWord; u += kLanes) {
      bits |= maxima(at, u) << u;
    }
    word.edges &= bits;
    word.strong = word.edges & above(at.here, thresholds.strong);
  }
  return word;
}
#endif

/// Finds each pixel's class, no edge, weak or strong, keeping the gradients of three rows.
template <typename SuppressWord>
EDVO_INLINE void classify(const ByteImage& image, const SuppressWord& suppress_word,
                          std::array<GradientRow, 3>& buffers, Hysteresis& edges) {
  std::array<GradientRow*, 3> rows{&buffers[0], &buffers[1], &buffers[2]};
  rows[1]->clear();
  rows[2]->compute(image, 0);
  for (int v = 0; v < image.rows; ++v) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    if (v + 1 < image.rows) {
      rows[2]->compute(image, v + 1);
    } else {
      rows[2]->clear();
    }
    for (int word = 0; word * kPixelsPerWord < image.cols; ++word) {
      const Neighbourhood at({rows[0], rows[1], rows[2]}, word * kPixelsPerWord);
      edges.set(v, word, suppress_word(at));
    }
  }
}

EDVO_TARGET_AVX2 void classify_avx2(const ByteImage& image, SquaredThresholds thresholds,
                                    std::array<GradientRow, 3>& rows, Hysteresis& edges) {
  const auto suppress_word = [&](const Neighbourhood& at)
                                 EDVO_TARGET_AVX2 { return suppressed(at, thresholds); };
  classify(image, suppress_word, rows, edges);
}

#if defined(EDVO_HAS_MASKS)
EDVO_TARGET_AVX512 void classify_avx512(const ByteImage& image, SquaredThresholds thresholds,
                                        std::array<GradientRow, 3>& rows, Hysteresis& edges) {
  const auto suppress_word = [&](const Neighbourhood& at)
                                 EDVO_TARGET_AVX512 { return suppressed_avx512(at, thresholds); };
  classify(image, suppress_word, rows, edges);
}
#else
void classify_avx512(const ByteImage& image, SquaredThresholds thresholds,
                     std::array<GradientRow, 3>& rows, Hysteresis& edges) {
  classify_avx2(image, thresholds, rows, edges);
}
#endif

void classify_baseline(const ByteImage& image, SquaredThresholds thresholds,
                       std::array<GradientRow, 3>& rows, Hysteresis& edges) {
  const auto suppress_word = [&](const Neighbourhood& at) { return suppressed(at, thresholds); };
  classify(image, suppress_word, rows, edges);
}

}  // namespace

void Canny::find(const ByteImage& image, double weak, double strong, InstructionSet set,
                 EdgeMask& edges) {
  const SquaredThresholds thresholds = squared_thresholds(weak, strong);
  for (GradientRow& row : rows_) {
    row.resize(image.cols);
  }
  hysteresis_.reset(image.size());
  version_for(set, classify_baseline, classify_avx2, classify_avx512)(image, thresholds, rows_,
                                                                      hysteresis_);
  hysteresis_.follow();
  edges.create(image.size());
  hysteresis_.write_strong(edges);
}

}  // namespace vo
