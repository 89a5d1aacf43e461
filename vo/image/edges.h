#pragma once

#include <array>
#include <utility>

#include "vo/core/image.h"

namespace vo {

/// How Canny's strong threshold is chosen, per image and so per pyramid level.
enum class EdgeThreshold {
  otsu,        ///< Otsu's threshold of the intensities, as the paper's authors use it
  percentile,  ///< a percentile of the gradient magnitudes: as many edges whatever the contrast
  fixed,       ///< a given gradient magnitude
};

constexpr auto enum_names(EdgeThreshold) {
  return std::array{std::pair{EdgeThreshold::otsu, "otsu"},
                    std::pair{EdgeThreshold::percentile, "percentile"},
                    std::pair{EdgeThreshold::fixed, "fixed"}};
}

/// Canny edges. Gradient magnitudes are Euclidean, of 3x3 Sobel kernels on intensities 0..255.
struct EdgeOptions {
  EdgeThreshold threshold = EdgeThreshold::percentile;
  double percentile = 88;   ///< %, of pixels with a weaker gradient than the strong threshold
  double strong = 100;      ///< Sobel magnitude, for `fixed`
  double weak_ratio = 0.5;  ///< weak threshold, as a share of the strong one
  double floor = 20;        ///< Sobel magnitude below which a percentile is noise

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, EdgeOptions& options) {
  visit("threshold", options.threshold, "how the strong threshold is chosen");
  visit("percentile", options.percentile, "% of pixels below the strong threshold (percentile)");
  visit("strong", options.strong, "strong threshold, Sobel magnitude (fixed)");
  visit("weak_ratio", options.weak_ratio, "weak threshold as a share of the strong one");
  visit("floor", options.floor, "least strong threshold, Sobel magnitude (percentile)");
}

EdgeMask detect_edges(const GrayImage& gray, const EdgeOptions& options);

}  // namespace vo
