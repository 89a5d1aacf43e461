#include "vo/image/gray_without_vignette.h"

#include "vo/core/instruction_set.h"
#include "vo/image/vignette_gains.h"

namespace vo {
namespace {

EDVO_INLINE void scale_row(const detail::RowGains& gains, const uchar* __restrict bytes, int cols,
                           float* __restrict gray) {
  constexpr auto kScale = static_cast<float>(1.0 / 255);
  for (int u = 0; u < cols; ++u) {
    gray[u] = static_cast<float>(bytes[u]) * kScale * gains.at(u);
  }
}

EDVO_TARGET_AVX2 void scale_row_avx2(const detail::RowGains& gains, const uchar* bytes, int cols,
                                     float* gray) {
  scale_row(gains, bytes, cols, gray);
}

void scale_row_baseline(const detail::RowGains& gains, const uchar* bytes, int cols, float* gray) {
  scale_row(gains, bytes, cols, gray);
}

}  // namespace

void to_gray_without(const Vignette& vignette, const PinholeCamera& camera, const ByteImage& bytes,
                     GrayImage& gray) {
  const auto scale =
      available_instruction_set() == InstructionSet::baseline ? scale_row_baseline : scale_row_avx2;
  make_writable(gray, bytes.size());
  detail::RowGains gains(vignette, camera);
  for (int v = 0; v < bytes.rows; ++v) {
    gains.go_to_row(v);
    scale(gains, bytes[v], bytes.cols, gray[v]);
  }
}

}  // namespace vo
