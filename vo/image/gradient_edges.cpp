#include "vo/image/gradient_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "vo/image/canny.h"
#include "vo/image/edge_thinning.h"

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

/// The magnitude below which a share of the pixels lies. Evenly spread rows stand for the image.
double gradient_quantile(const ByteImage& image, double share) {
  constexpr int kRows = 60;
  const std::vector<int> histogram = sobel_magnitude_histogram(
      image, std::max(1, image.rows / kRows), available_instruction_set());
  const double wanted = share * std::accumulate(histogram.begin(), histogram.end(), 0);
  double below = 0;
  std::size_t magnitude = 0;
  while (magnitude + 1 < histogram.size() && below + histogram[magnitude] < wanted) {
    below += histogram[magnitude++];
  }
  return static_cast<double>(magnitude);
}

/// The least whole magnitude that at most `count` pixels reach.
double gradient_of_count(const ByteImage& image, int count) {
  const std::vector<int> histogram =
      sobel_magnitude_histogram(image, 1, available_instruction_set());
  int above = 0;
  std::size_t magnitude = histogram.size();
  while (magnitude > 0 && above + histogram[magnitude - 1] <= count) {
    above += histogram[--magnitude];
  }
  return static_cast<double>(magnitude);
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
