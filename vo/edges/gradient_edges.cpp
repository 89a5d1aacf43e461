#include "vo/edges/gradient_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include <opencv2/imgproc.hpp>

#include "vo/core/instruction_set.h"
#include "vo/structured_forest/edge_thinning.h"

namespace vo {
namespace {

/// Converts a row from 0..1 to 0..255. In a sum with 1.5 2^23 the last bits of a float count ones:
/// a half is rounded to the even number, as cv::Mat::convertTo does.
EDVO_INLINE void convert_row(const float* gray, std::size_t cols, uchar* __restrict bytes) {
  constexpr float kOnes = 0x1.8p23F;
  for (std::size_t u = 0; u < cols; ++u) {
    const int rounded = std::bit_cast<int>(255 * gray[u] + kOnes) - std::bit_cast<int>(kOnes);
    bytes[u] = static_cast<uchar>(std::min(std::max(rounded, 0), 255));
  }
}

EDVO_TARGET_AVX2 void convert_row_avx2(const float* gray, std::size_t cols, uchar* bytes) {
  convert_row(gray, cols, bytes);
}

void convert_row_baseline(const float* gray, std::size_t cols, uchar* bytes) {
  convert_row(gray, cols, bytes);
}

/// Returns the image as 0..255, its pixels in `memory`.
ByteImage to_bytes(const GrayImage& gray, std::vector<uchar>& memory) {
  const auto convert_row = available_instruction_set() == InstructionSet::baseline
                               ? convert_row_baseline
                               : convert_row_avx2;
  memory.resize(std::max(memory.size(), gray.total()));
  ByteImage bytes(gray.rows, gray.cols, memory.data());
  for (int v = 0; v < gray.rows; ++v) {
    convert_row(gray[v], static_cast<std::size_t>(gray.cols), bytes[v]);
  }
  return bytes;
}

double otsu_threshold(const ByteImage& image) {
  ByteImage unused;
  return cv::threshold(image, unused, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
}

/// Returns the least whole magnitude that is great enough, if all greater ones are, too.
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

/// Returns the magnitude below which a share of the pixels lies, estimated from evenly spread rows.
double gradient_quantile(const ByteImage& image, double share, SobelMagnitudes& magnitudes) {
  constexpr int kRows = 60;
  magnitudes.measure(image, std::max(1, image.rows / kRows), available_instruction_set());
  const double wanted = share * magnitudes.count();
  return least_magnitude(SobelMagnitudes::kGreatest, [&](int magnitude) {
    return magnitudes.count_below(magnitude + 1) >= wanted;
  });
}

/// Returns the least whole magnitude that at most `count` pixels reach.
double gradient_of_count(const ByteImage& image, int count, SobelMagnitudes& magnitudes) {
  magnitudes.measure(image, 1, available_instruction_set());
  return least_magnitude(SobelMagnitudes::kGreatest + 1, [&](int magnitude) {
    return magnitudes.count() - magnitudes.count_below(magnitude) <= count;
  });
}

double strong_threshold(const ByteImage& image, const EdgeOptions& options,
                        SobelMagnitudes& magnitudes) {
  switch (options.threshold) {
    case EdgeThreshold::otsu:
      return otsu_threshold(image);
    case EdgeThreshold::percentile:
      return std::max(options.floor,
                      gradient_quantile(image, options.percentile / 100, magnitudes));
    case EdgeThreshold::target_count:
      return std::max(options.floor, gradient_of_count(image, options.target_count, magnitudes));
    case EdgeThreshold::fixed:
      break;
  }
  return options.strong;
}

}  // namespace

void CannyEdges::find(const GrayImage& gray, const EdgeOptions& options, EdgeMask& edges) {
  const ByteImage image = to_bytes(gray, bytes_);
  const double strong = strong_threshold(image, options, magnitudes_);
  canny_.find(image, options.weak_ratio * strong, strong, available_instruction_set(), edges);
}

EdgeMask sobel_edges(const GrayImage& gray, const EdgeOptions& options) {
  std::vector<uchar> bytes;
  SobelMagnitudes magnitudes;
  const ByteImage image = to_bytes(gray, bytes);
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
  cv::Mat edges = strength >= std::max(1.0, strong_threshold(image, options, magnitudes));
  return edges;
}

}  // namespace vo
