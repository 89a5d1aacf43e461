#include "vo/image/gradient_edges.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vo/image/canny.h"
#include "vo/image/edge_thinning.h"
#include "vo/image/sobel_magnitudes.h"

namespace vo {
namespace {

ByteImage to_bytes(const GrayImage& gray) {
  ByteImage bytes;
  gray.convertTo(bytes, CV_8U, 255);
  return bytes;
}

double otsu_threshold(const ByteImage& image) {
  ByteImage unused;
  return cv::threshold(image, unused, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
}

/// The least whole magnitude that is great enough, which all greater ones are, too.
template <typename IsGreatEnough>
int least_magnitude(int greatest, IsGreatEnough is_great_enough) {
  int low = 0;
  int high = greatest;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (is_great_enough(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return high;
}

/// The magnitude below which a share of the pixels lies. Evenly spread rows stand for the image.
double gradient_quantile(const ByteImage& image, double share) {
  constexpr int kRows = 60;
  const SobelMagnitudes magnitudes(image, std::max(1, image.rows / kRows),
                                   available_instruction_set());
  const double wanted = share * magnitudes.count();
  return least_magnitude(SobelMagnitudes::kGreatest, [&](int magnitude) {
    return magnitudes.count_below(magnitude + 1) >= wanted;
  });
}

/// The least whole magnitude that at most `count` pixels reach.
double gradient_of_count(const ByteImage& image, int count) {
  const SobelMagnitudes magnitudes(image, 1, available_instruction_set());
  return least_magnitude(SobelMagnitudes::kGreatest + 1, [&](int magnitude) {
    return magnitudes.count() - magnitudes.count_below(magnitude) <= count;
  });
}

double strong_threshold(const ByteImage& image, const EdgeOptions& options) {
  switch (options.threshold) {
    case EdgeThreshold::otsu:
      return otsu_threshold(image);
    case EdgeThreshold::percentile:
      return std::max(options.floor, gradient_quantile(image, options.percentile / 100));
    case EdgeThreshold::target_count:
      return std::max(options.floor, gradient_of_count(image, options.target_count));
    case EdgeThreshold::fixed:
      break;
  }
  return options.strong;
}

}  // namespace

EdgeMask canny_edges(const GrayImage& gray, const EdgeOptions& options) {
  const ByteImage image = to_bytes(gray);
  const double strong = strong_threshold(image, options);
  return canny(image, options.weak_ratio * strong, strong, available_instruction_set());
}

EdgeMask sobel_edges(const GrayImage& gray, const EdgeOptions& options) {
  const ByteImage image = to_bytes(gray);
  cv::Mat_<float> dx;
  cv::Mat_<float> dy;
  cv::Sobel(image, dx, CV_32F, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
  cv::Sobel(image, dy, CV_32F, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);
  cv::Mat_<float> strength(gray.size());
  GradientImage across(gray.size());
  for (int v = 0; v < gray.rows; ++v) {
    for (int u = 0; u < gray.cols; ++u) {
      const cv::Vec2f gradient(dx(v, u), dy(v, u));
      strength(v, u) = std::sqrt(gradient.dot(gradient));
      across(v, u) = gradient * (strength(v, u) > 0 ? 1 / strength(v, u) : 0);
    }
  }
  if (options.sobel_thin) {
    strength = thinned(strength, across, 1);
  }
  cv::Mat edges = strength >= std::max(1.0, strong_threshold(image, options));
  return edges;
}

}  // namespace vo
