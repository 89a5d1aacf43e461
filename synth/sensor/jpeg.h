#pragma once

#include <array>
#include <utility>

#include "vo/core/image.h"

namespace synth {

enum class ChromaSampling {
  full,    ///< 4:4:4
  half,    ///< 4:2:2, half the columns
  quarter  ///< 4:2:0, half the columns and rows
};

constexpr auto enum_names(ChromaSampling) {
  return std::array{std::pair{ChromaSampling::full, "full"},
                    std::pair{ChromaSampling::half, "half"},
                    std::pair{ChromaSampling::quarter, "quarter"}};
}

struct JpegOptions {
  int quality = 0;  ///< 1 to 100; 0 = not compressed
  ChromaSampling chroma = ChromaSampling::quarter;

  void validate() const;  ///< throws vo::Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, JpegOptions& options) {
  visit("quality", options.quality, "of JPEG compression, 1 to 100; 0 = none");
  visit("chroma", options.chroma, "samples of colour per pixel");
}

/// The image as it comes back from JPEG.
vo::ColorImage through_jpeg(const vo::ColorImage& image, const JpegOptions& options);

}  // namespace synth
