#include "vo/image/gradient_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "vo/image/edge_thinning.h"

namespace vo {
namespace {

using ShortImage = cv::Mat_<short>;

struct SobelImage {
  ByteImage intensity;
  ShortImage dx;
  ShortImage dy;
};

SobelImage sobel(const GrayImage& gray) {
  SobelImage image;
  gray.convertTo(image.intensity, CV_8U, 255);
  cv::Sobel(image.intensity, image.dx, CV_16S, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
  cv::Sobel(image.intensity, image.dy, CV_16S, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);
  return image;
}

float magnitude(const SobelImage& image, int v, int u) {
  const auto gx = static_cast<float>(image.dx(v, u));
  const auto gy = static_cast<float>(image.dy(v, u));
  return std::sqrt(gx * gx + gy * gy);
}

double otsu_threshold(const ByteImage& image) {
  ByteImage unused;
  return cv::threshold(image, unused, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
}

/// Pixels by the whole part of their gradient's magnitude.
std::vector<int> magnitude_histogram(const SobelImage& image) {
  constexpr int kMaxMagnitude = 1443;  // 1020 sqrt(2)
  std::vector<int> histogram(kMaxMagnitude + 1);
  for (int v = 0; v < image.dx.rows; ++v) {
    for (int u = 0; u < image.dx.cols; ++u) {
      ++histogram[static_cast<std::size_t>(magnitude(image, v, u))];
    }
  }
  return histogram;
}

/// The magnitude below which `wanted` pixels lie.
double gradient_quantile(const SobelImage& image, double wanted) {
  const std::vector<int> histogram = magnitude_histogram(image);
  double below = 0;
  std::size_t magnitude = 0;
  while (magnitude + 1 < histogram.size() && below + histogram[magnitude] < wanted) {
    below += histogram[magnitude++];
  }
  return static_cast<double>(magnitude);
}

/// The least whole magnitude that at most `count` pixels reach.
double gradient_of_count(const SobelImage& image, int count) {
  const std::vector<int> histogram = magnitude_histogram(image);
  int above = 0;
  std::size_t magnitude = histogram.size();
  while (magnitude > 0 && above + histogram[magnitude - 1] <= count) {
    above += histogram[--magnitude];
  }
  return static_cast<double>(magnitude);
}

double strong_threshold(const SobelImage& image, const EdgeOptions& options) {
  switch (options.threshold) {
    case EdgeThreshold::otsu:
      return otsu_threshold(image.intensity);
    case EdgeThreshold::percentile:
      return std::max(options.floor,
                      gradient_quantile(
                          image, options.percentile / 100 * static_cast<double>(image.dx.total())));
    case EdgeThreshold::target_count:
      return std::max(options.floor, gradient_of_count(image, options.target_count));
    case EdgeThreshold::fixed:
      break;
  }
  return options.strong;
}

}  // namespace

EdgeMask canny_edges(const GrayImage& gray, const EdgeOptions& options) {
  const SobelImage image = sobel(gray);
  const double strong = strong_threshold(image, options);
  EdgeMask edges;
  cv::Canny(image.dx, image.dy, edges, options.weak_ratio * strong, strong, /*L2gradient=*/true);
  return edges;
}

EdgeMask sobel_edges(const GrayImage& gray, const EdgeOptions& options) {
  const SobelImage image = sobel(gray);
  const double strong = strong_threshold(image, options);
  cv::Mat_<float> strength(gray.size());
  GradientImage across(gray.size());
  for (int v = 0; v < gray.rows; ++v) {
    for (int u = 0; u < gray.cols; ++u) {
      strength(v, u) = magnitude(image, v, u);
      const float scale = strength(v, u) > 0 ? 1 / strength(v, u) : 0;
      across(v, u) = {scale * static_cast<float>(image.dx(v, u)),
                      scale * static_cast<float>(image.dy(v, u))};
    }
  }
  if (options.sobel_thin) {
    strength = thinned(strength, across, 1);
  }
  cv::Mat edges = strength >= std::max(1.0, strong);
  return edges;
}

}  // namespace vo
