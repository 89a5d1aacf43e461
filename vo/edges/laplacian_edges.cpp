#include "vo/edges/laplacian_edges.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

namespace vo {
namespace {

void mark_crossing(const cv::Mat_<float>& laplacian, const cv::Point& a, const cv::Point& b,
                   double least_step, EdgeMask& edges) {
  const float at_a = laplacian(a);
  const float at_b = laplacian(b);
  const bool has_other_sign = (at_a < 0) != (at_b < 0);
  if (has_other_sign && std::abs(at_a - at_b) >= least_step) {
    edges(std::abs(at_a) <= std::abs(at_b) ? a : b) = 255;
  }
}

}  // namespace

EdgeMask laplacian_edges(const GrayImage& gray, const EdgeOptions& options) {
  cv::Mat smooth;
  cv::GaussianBlur(gray, smooth, {}, options.log_sigma, options.log_sigma, cv::BORDER_REPLICATE);
  cv::Mat_<float> laplacian;
  cv::Laplacian(smooth, laplacian, CV_32F, 1, 255, 0, cv::BORDER_REPLICATE);
  EdgeMask edges(gray.size(), 0);
  for (int v = 0; v < gray.rows; ++v) {
    for (int u = 0; u < gray.cols; ++u) {
      if (u + 1 < gray.cols) {
        mark_crossing(laplacian, {u, v}, {u + 1, v}, options.log_strength, edges);
      }
      if (v + 1 < gray.rows) {
        mark_crossing(laplacian, {u, v}, {u, v + 1}, options.log_strength, edges);
      }
    }
  }
  return edges;
}

}  // namespace vo
