#pragma once

#include <array>
#include <filesystem>
#include <utility>

namespace vo {

/// The detector that finds the edges.
enum class EdgeDetector {
  canny,              ///< gradient maxima, linked by hysteresis
  log,                ///< zero crossings of the Laplacian of a Gaussian
  sobel,              ///< strong gradients
  structured_forest,  ///< learnt: Dollar & Zitnick, ICCV 2013
};

constexpr auto enum_names(EdgeDetector) {
  return std::array{std::pair{EdgeDetector::canny, "canny"}, std::pair{EdgeDetector::log, "log"},
                    std::pair{EdgeDetector::sobel, "sobel"},
                    std::pair{EdgeDetector::structured_forest, "structured_forest"}};
}

/// The way in which the strong gradient threshold is chosen, for each image and so each pyramid
/// level.
enum class EdgeThreshold {
  otsu,          ///< Otsu's threshold of the intensities, as the paper's authors use it
  percentile,    ///< a percentile of the gradient magnitudes, independent of contrast
  fixed,         ///< a given gradient magnitude
  target_count,  ///< a number of pixels above it, independent of contrast and resolution
};

constexpr auto enum_names(EdgeThreshold) {
  return std::array{std::pair{EdgeThreshold::otsu, "otsu"},
                    std::pair{EdgeThreshold::percentile, "percentile"},
                    std::pair{EdgeThreshold::fixed, "fixed"},
                    std::pair{EdgeThreshold::target_count, "target_count"}};
}

/// Options of the edge detectors. Gradient magnitudes are Euclidean, of 3x3 Sobel kernels on
/// intensities 0..255.
struct EdgeOptions {
  EdgeDetector detector = EdgeDetector::canny;
  EdgeThreshold threshold = EdgeThreshold::percentile;  ///< for canny and sobel
  double percentile = 88;    ///< % of pixels with a weaker gradient than the strong threshold
  int target_count = 20000;  ///< most pixels with a gradient of at least the strong threshold
  double strong = 100;       ///< strong threshold, Sobel magnitude, for `fixed`
  double weak_ratio = 0.5;   ///< canny: weak threshold, as a share of the strong one
  double floor = 20;         ///< Sobel magnitude, least threshold by percentile or count
  bool sobel_thin = true;    ///< sobel: keep only maxima across the edge
  double log_sigma = 1.4;    ///< px, standard deviation of the Gaussian
  double log_strength = 4;   ///< least step of the Laplacian, intensity (0..255) per px^2
  std::filesystem::path forest_model;  ///< OpenCV's model format, .yml or .yml.gz
  int forest_scale = 2;                ///< factor by which the image is enlarged for the forest
  double forest_strength = 0.4;        ///< 0..1, least strength of edges after thinning

  void validate() const;  ///< throws Error unless the values are usable
};

template <typename Visitor>
void visit_fields(Visitor& visit, EdgeOptions& options) {
  visit("detector", options.detector, "what finds the edges");
  visit("threshold", options.threshold, "how the strong threshold is chosen (canny, sobel)");
  visit("percentile", options.percentile, "% of pixels below the strong threshold (percentile)");
  visit("target_count", options.target_count, "pixels above the strong threshold (target_count)");
  visit("strong", options.strong, "strong threshold, Sobel magnitude (fixed)");
  visit("weak_ratio", options.weak_ratio, "weak threshold as a share of the strong one (canny)");
  visit("floor", options.floor, "least strong threshold, Sobel magnitude (percentile, count)");
  visit("sobel_thin", options.sobel_thin, "keep only maxima across the edge (sobel)");
  visit("log_sigma", options.log_sigma, "of the Gaussian, px (log)");
  visit("log_strength", options.log_strength, "least step at a zero crossing, per px^2 (log)");
  visit("forest_model", options.forest_model, "model file in OpenCV's format (structured_forest)");
  visit("forest_scale", options.forest_scale, "enlargement before (structured_forest)");
  visit("forest_strength", options.forest_strength, "least edge strength (structured_forest)");
}

}  // namespace vo
