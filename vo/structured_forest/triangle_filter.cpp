#include "vo/structured_forest/triangle_filter.h"

#include <algorithm>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace vo {

cv::Mat smoothed_by_triangle(const cv::Mat& image, int radius) {
  if (radius == 0) {
    return image;
  }
  const std::size_t size = 2 * static_cast<std::size_t>(radius) + 1;
  const float peak = static_cast<float>(radius) + 1;
  std::vector<float> kernel(size);
  for (std::size_t i = 0; i < size; ++i) {
    kernel[i] = static_cast<float>(std::min(i + 1, size - i)) / (peak * peak);
  }
  cv::Mat result;
  cv::sepFilter2D(image, result, -1, kernel, kernel);
  return result;
}

}  // namespace vo
