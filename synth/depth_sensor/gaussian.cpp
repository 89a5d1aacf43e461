#include "synth/depth_sensor/gaussian.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace synth {
namespace {

template <typename Pixel>
Pixel weighted_sum(const std::vector<float>& kernel, const Pixel* middle, std::ptrdiff_t step) {
  Pixel sum = middle[0] * kernel[0];
  for (std::size_t i = 1; i < kernel.size(); ++i) {
    const auto offset = static_cast<std::ptrdiff_t>(i) * step;
    sum += (middle[-offset] + middle[offset]) * kernel[i];
  }
  return sum;
}

/// Returns the separable convolution without the border, which is the kernel's radius wide.
template <typename Pixel>
cv::Mat_<Pixel> convolved(const cv::Mat_<Pixel>& padded, const std::vector<float>& kernel) {
  const int radius = static_cast<int>(kernel.size()) - 1;
  cv::Mat_<Pixel> rows(padded.rows, padded.cols - 2 * radius);
  for (int v = 0; v < rows.rows; ++v) {
    for (int u = 0; u < rows.cols; ++u) {
      rows(v, u) = weighted_sum(kernel, &padded(v, u + radius), 1);
    }
  }
  cv::Mat_<Pixel> result(padded.rows - 2 * radius, rows.cols);
  for (int v = 0; v < result.rows; ++v) {
    for (int u = 0; u < result.cols; ++u) {
      result(v, u) = weighted_sum(kernel, &rows(v + radius, u), rows.cols);
    }
  }
  return result;
}

}  // namespace

std::vector<float> gaussian_kernel(double sigma_px) {
  const int radius = static_cast<int>(std::ceil(4 * sigma_px));
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i <= radius; ++i) {
    weights.push_back(i == 0 ? 1 : std::exp(-i * i / (2 * sigma_px * sigma_px)));
    sum += i == 0 ? 1 : 2 * weights.back();
  }
  std::vector<float> kernel;
  for (const double weight : weights) {
    kernel.push_back(static_cast<float>(weight / sum));
  }
  return kernel;
}

cv::Mat_<cv::Vec3f> blurred(const cv::Mat_<cv::Vec3f>& image, double sigma_px) {
  const std::vector<float> kernel = gaussian_kernel(sigma_px);
  const int radius = static_cast<int>(kernel.size()) - 1;
  cv::Mat_<cv::Vec3f> padded;
  cv::copyMakeBorder(image, padded, radius, radius, radius, radius, cv::BORDER_REPLICATE);
  return convolved(padded, kernel);
}

cv::Mat_<float> noise_image(const cv::Size& size, double correlation_px,
                            const vo::RandomField& random) {
  const std::vector<float> kernel = gaussian_kernel(correlation_px);
  const int radius = static_cast<int>(kernel.size()) - 1;
  cv::Mat_<float> white(size.height + 2 * radius, size.width + 2 * radius);
  for (int v = 0; v < white.rows; ++v) {
    for (int u = 0; u < white.cols; ++u) {
      white(v, u) = static_cast<float>(random.normal(u - radius, v - radius));
    }
  }
  double variance = -static_cast<double>(kernel[0]) * kernel[0];  // after each of both passes
  for (const float weight : kernel) {
    variance += 2.0 * weight * weight;
  }
  cv::Mat_<float> result = convolved(white, kernel);
  result *= 1 / variance;
  return result;
}

}  // namespace synth
