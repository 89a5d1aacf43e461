#include "vo/image/canny.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "vo/image/hysteresis.h"
#include "vo/image/pixel_bits.h"

namespace vo {
namespace {

constexpr std::size_t kMaxMagnitude = 1442;  // floor(1020 sqrt(2))

/// Gradients of one row of the image. Squared magnitudes have a zero on either side.
class GradientRow {
 public:
  explicit GradientRow(int cols)
      : smooth_(static_cast<std::size_t>(cols) + 2),
        difference_(smooth_.size()),
        dx_(static_cast<std::size_t>(cols)),
        dy_(dx_.size()),
        squared_(smooth_.size()) {}

  EDVO_INLINE void compute(const ByteImage& image, int v) {
    const uchar* above = image[std::max(v - 1, 0)];
    const uchar* here = image[v];
    const uchar* below = image[std::min(v + 1, image.rows - 1)];
    const std::size_t cols = dx_.size();
    std::int16_t* __restrict smooth = smooth_.data();
    std::int16_t* __restrict difference = difference_.data();
    for (std::size_t u = 0; u < cols; ++u) {
      smooth[u + 1] = static_cast<std::int16_t>(above[u] + 2 * here[u] + below[u]);
      difference[u + 1] = static_cast<std::int16_t>(below[u] - above[u]);
    }
    smooth[0] = smooth[1];
    smooth[cols + 1] = smooth[cols];
    difference[0] = difference[1];
    difference[cols + 1] = difference[cols];
    int* __restrict dx = dx_.data();
    int* __restrict dy = dy_.data();
    int* __restrict squared = squared_.data();
    for (std::size_t u = 0; u < cols; ++u) {
      const int gx = smooth[u + 2] - smooth[u];
      const int gy = difference[u] + 2 * difference[u + 1] + difference[u + 2];
      dx[u] = gx;
      dy[u] = gy;
      squared[u + 1] = gx * gx + gy * gy;
    }
  }

  void clear() { std::fill(squared_.begin(), squared_.end(), 0); }

  const int* dx() const { return dx_.data(); }
  const int* dy() const { return dy_.data(); }
  const int* squared() const { return squared_.data() + 1; }  ///< valid from -1 to the width

 private:
  std::vector<std::int16_t> smooth_;      ///< of the columns, a pixel more on either side
  std::vector<std::int16_t> difference_;  ///< likewise
  std::vector<int> dx_, dy_, squared_;
};

/// Squared magnitudes that a pixel must exceed.
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

/// The squared magnitudes of three rows and the gradient of the middle one, from some column on.
struct Neighbourhood {
  const int* above;
  const int* here;
  const int* below;
  const int* dx;
  const int* dy;

  EDVO_INLINE Neighbourhood(const std::array<const GradientRow*, 3>& rows, int u)
      : above(rows[0]->squared() + u),
        here(rows[1]->squared() + u),
        below(rows[2]->squared() + u),
        dx(rows[1]->dx() + u),
        dy(rows[1]->dy() + u) {}
};

/// Keeps the maxima across the edge. The direction is horizontal below 22.5 deg, vertical above
/// 67.5 deg, else one of the diagonals; tan(22.5 deg) in units of 2^-15.
EDVO_INLINE void suppress(const Neighbourhood& at, int count, SquaredThresholds thresholds,
                          uchar* __restrict classes) {
  constexpr int kShift = 15;
  constexpr int kTan22 = 13573;
  for (int u = 0; u < count; ++u) {
    const int gx = at.dx[u];
    const int gy = at.dy[u];
    const int x = (gx ^ (gx >> 31)) - (gx >> 31);  // |gx|, in a form that is vectorized
    const int y = ((gy ^ (gy >> 31)) - (gy >> 31)) << kShift;
    const int horizontal = y < x * kTan22 ? -1 : 0;
    const int vertical = y > x * kTan22 + (x << (kShift + 1)) ? -1 : 0;
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
    classes[u] = static_cast<uchar>((is_maximum & is_weak) + 2 * (is_maximum & is_strong));
  }
}

EDVO_INLINE bool any_above(const int* squared, int count, int threshold) {
  int greatest = threshold;
  for (int u = 0; u < count; ++u) {
    greatest = squared[u] > greatest ? squared[u] : greatest;
  }
  return greatest > threshold;
}

/// Where no gradient is strong enough there is nothing to suppress.
EDVO_INLINE void suppress_row(const std::array<const GradientRow*, 3>& rows, int v, int cols,
                              SquaredThresholds thresholds, Hysteresis& edges) {
  alignas(kPixelsPerWord) std::array<uchar, kPixelsPerWord> classes{};
  for (int word = 0; word * kPixelsPerWord < cols; ++word) {
    const Neighbourhood at(rows, word * kPixelsPerWord);
    const int count = cols - word * kPixelsPerWord;
    if (count < kPixelsPerWord) {
      classes.fill(no_edge);
      suppress(at, count, thresholds, classes.data());
      edges.set(v, word, classes.data());
    } else if (any_above(at.here, kPixelsPerWord, thresholds.weak)) {
      suppress(at, kPixelsPerWord, thresholds, classes.data());
      edges.set(v, word, classes.data());
    }
  }
}

/// Each pixel's class.
EDVO_INLINE void classify(const ByteImage& image, SquaredThresholds thresholds, Hysteresis& edges) {
  std::array<GradientRow, 3> buffers{GradientRow(image.cols), GradientRow(image.cols),
                                     GradientRow(image.cols)};
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
    suppress_row({rows[0], rows[1], rows[2]}, v, image.cols, thresholds, edges);
  }
}

EDVO_INLINE void count_magnitudes(const ByteImage& image, int row_step,
                                  std::vector<int>& histogram) {
  GradientRow row(image.cols);
  std::vector<std::uint16_t> magnitudes(static_cast<std::size_t>(image.cols));
  std::vector<int> odd(histogram.size());  // two counters a bin: neighbours often share one
  for (int v = row_step / 2; v < image.rows; v += row_step) {
    row.compute(image, v);
    const int* squared = row.squared();
    for (int u = 0; u < image.cols; ++u) {
      magnitudes[static_cast<std::size_t>(u)] =
          static_cast<std::uint16_t>(static_cast<int>(std::sqrt(static_cast<float>(squared[u]))));
    }
    std::size_t u = 0;
    for (; u + 1 < magnitudes.size(); u += 2) {
      ++histogram[magnitudes[u]];
      ++odd[magnitudes[u + 1]];
    }
    if (u < magnitudes.size()) {
      ++histogram[magnitudes[u]];
    }
  }
  for (std::size_t bin = 0; bin < odd.size(); ++bin) {
    histogram[bin] += odd[bin];
  }
}

EDVO_TARGET_AVX512 void classify_avx512(const ByteImage& image, SquaredThresholds thresholds,
                                        Hysteresis& edges) {
  classify(image, thresholds, edges);
}

EDVO_TARGET_AVX2 void classify_avx2(const ByteImage& image, SquaredThresholds thresholds,
                                    Hysteresis& edges) {
  classify(image, thresholds, edges);
}

void classify_baseline(const ByteImage& image, SquaredThresholds thresholds, Hysteresis& edges) {
  classify(image, thresholds, edges);
}

EDVO_TARGET_AVX2 void count_avx2(const ByteImage& image, int row_step,
                                 std::vector<int>& histogram) {
  count_magnitudes(image, row_step, histogram);
}

void count_baseline(const ByteImage& image, int row_step, std::vector<int>& histogram) {
  count_magnitudes(image, row_step, histogram);
}

}  // namespace

std::vector<int> sobel_magnitude_histogram(const ByteImage& image, int row_step,
                                           InstructionSet set) {
  std::vector<int> histogram(kMaxMagnitude + 1);
  if (set == InstructionSet::baseline) {
    count_baseline(image, row_step, histogram);
  } else {
    count_avx2(image, row_step, histogram);
  }
  return histogram;
}

EdgeMask canny(const ByteImage& image, double weak, double strong, InstructionSet set) {
  const SquaredThresholds thresholds = squared_thresholds(weak, strong);
  Hysteresis edges(image.size());
  switch (set) {
    case InstructionSet::avx512:
      classify_avx512(image, thresholds, edges);
      break;
    case InstructionSet::avx2:
      classify_avx2(image, thresholds, edges);
      break;
    default:
      classify_baseline(image, thresholds, edges);
  }
  edges.follow();
  return edges.strong();
}

}  // namespace vo
