#include "vo/image/sobel_magnitudes.h"

#include <algorithm>

#include "vo/image/gradient_row.h"

namespace vo {
namespace {

EDVO_INLINE void square_rows(const ByteImage& image, int first, int step, int* squares) {
  GradientRow row(image.cols);
  for (int v = first; v < image.rows; v += step) {
    row.compute(image, v);
    squares = std::copy_n(row.squared(), image.cols, squares);
  }
}

EDVO_TARGET_AVX2 void square_rows_avx2(const ByteImage& image, int first, int step, int* squares) {
  square_rows(image, first, step, squares);
}

void square_rows_baseline(const ByteImage& image, int first, int step, int* squares) {
  square_rows(image, first, step, squares);
}

EDVO_INLINE int count_less(const std::vector<int>& values, int limit) {
  int count = 0;
  for (const int value : values) {
    count += value < limit ? 1 : 0;
  }
  return count;
}

EDVO_TARGET_AVX2 int count_less_avx2(const std::vector<int>& values, int limit) {
  return count_less(values, limit);
}

int count_less_baseline(const std::vector<int>& values, int limit) {
  return count_less(values, limit);
}

}  // namespace

SobelMagnitudes::SobelMagnitudes(const ByteImage& image, int row_step, InstructionSet set)
    : set_(set) {
  const int first = row_step / 2;
  const int rows = (std::max(image.rows - first, 0) + row_step - 1) / row_step;
  squares_.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(image.cols));
  if (set == InstructionSet::baseline) {
    square_rows_baseline(image, first, row_step, squares_.data());
  } else {
    square_rows_avx2(image, first, row_step, squares_.data());
  }
}

int SobelMagnitudes::count_below(int magnitude) const {
  return set_ == InstructionSet::baseline ? count_less_baseline(squares_, magnitude * magnitude)
                                          : count_less_avx2(squares_, magnitude * magnitude);
}

}  // namespace vo
