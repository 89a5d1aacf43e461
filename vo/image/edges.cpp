#include "vo/image/edges.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"

namespace vo {
namespace {

using ShortImage = cv::Mat_<short>;

double otsu_threshold(const ByteImage& image) {
  ByteImage unused;
  return cv::threshold(image, unused, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
}

double gradient_percentile(const ShortImage& dx, const ShortImage& dy, double percentile) {
  constexpr int kMaxMagnitude = 1443;  // 1020 sqrt(2)
  std::vector<int> histogram(kMaxMagnitude + 1);
  for (int v = 0; v < dx.rows; ++v) {
    for (int u = 0; u < dx.cols; ++u) {
      const auto gx = static_cast<float>(dx(v, u));
      const auto gy = static_cast<float>(dy(v, u));
      ++histogram[static_cast<std::size_t>(std::sqrt(gx * gx + gy * gy))];
    }
  }
  const double wanted = percentile / 100 * static_cast<double>(dx.total());
  double below = 0;
  std::size_t magnitude = 0;
  while (magnitude < kMaxMagnitude && below + histogram[magnitude] < wanted) {
    below += histogram[magnitude++];
  }
  return static_cast<double>(magnitude);
}

}  // namespace

void EdgeOptions::validate() const {
  require(percentile > 0 && percentile < 100, "edges.percentile: expected 0 to 100, got ",
          percentile);
  require(weak_ratio > 0 && weak_ratio <= 1, "edges.weak_ratio: expected 0 to 1, got ", weak_ratio);
  require(strong > 0 && floor > 0, "edges: expected thresholds above 0");
}

EdgeMask detect_edges(const GrayImage& gray, const EdgeOptions& options) {
  ByteImage image;
  gray.convertTo(image, CV_8U, 255);
  ShortImage dx;
  ShortImage dy;
  cv::Sobel(image, dx, CV_16S, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
  cv::Sobel(image, dy, CV_16S, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);

  double strong = options.strong;
  if (options.threshold == EdgeThreshold::otsu) {
    strong = otsu_threshold(image);
  } else if (options.threshold == EdgeThreshold::percentile) {
    strong = std::max(options.floor, gradient_percentile(dx, dy, options.percentile));
  }
  EdgeMask edges;
  cv::Canny(dx, dy, edges, options.weak_ratio * strong, strong, /*L2gradient=*/true);
  return edges;
}

}  // namespace vo
