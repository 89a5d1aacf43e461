#include "vo/edges/sobel_magnitudes.h"

#include <algorithm>

namespace vo {
namespace {

EDVO_INLINE void square_rows(const ByteImage& image, int step, GradientRow& row, int* squares) {
  for (int v = step / 2; v < image.rows; v += step) {
    row.compute(image, v);
    squares = std::copy_n(row.squared(), image.cols, squares);
  }
}

EDVO_TARGET_AVX2 void square_rows_avx2(const ByteImage& image, int step, GradientRow& row,
                                       int* squares) {
  square_rows(image, step, row, squares);
}

void square_rows_baseline(const ByteImage& image, int step, GradientRow& row, int* squares) {
  square_rows(image, step, row, squares);
}

EDVO_INLINE int count_less(const int* values, std::size_t size, int limit) {
  int count = 0;
  for (std::size_t i = 0; i < size; ++i) {
    count += values[i] < limit ? 1 : 0;
  }
  return count;
}

EDVO_TARGET_AVX2 int count_less_avx2(const int* values, std::size_t size, int limit) {
  return count_less(values, size, limit);
}

int count_less_baseline(const int* values, std::size_t size, int limit) {
  return count_less(values, size, limit);
}

}  // namespace

void SobelMagnitudes::measure(const ByteImage& image, int row_step, InstructionSet set) {
  set_ = set;
  row_.resize(image.cols);
  const int rows = (std::max(image.rows - row_step / 2, 0) + row_step - 1) / row_step;
  count_ = static_cast<std::size_t>(rows) * static_cast<std::size_t>(image.cols);
  squares_.resize(std::max(squares_.size(), count_));
  if (set == InstructionSet::baseline) {
    square_rows_baseline(image, row_step, row_, squares_.data());
  } else {
    square_rows_avx2(image, row_step, row_, squares_.data());
  }
}

int SobelMagnitudes::count_below(int magnitude) const {
  const auto count_less = set_ == InstructionSet::baseline ? count_less_baseline : count_less_avx2;
  return count_less(squares_.data(), count_, magnitude * magnitude);
}

}  // namespace vo
