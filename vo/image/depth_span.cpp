#include "vo/image/depth_span.h"

namespace vo {
namespace {

void add(float depth, DepthSpan& span) {
  const float measured = has_depth(depth) ? depth : span.nearest;
  span.nearest = std::min(span.nearest, measured);
  span.farthest = std::max(span.farthest, measured);
}

DepthSpan span_within(const DepthImage& depth, cv::Point pixel, int radius) {
  const int first_u = std::max(0, pixel.x - radius);
  const int last_u = std::min(depth.cols - 1, pixel.x + radius);
  const int last_v = std::min(depth.rows - 1, pixel.y + radius);
  DepthSpan span{depth(pixel), depth(pixel)};
  for (int v = std::max(0, pixel.y - radius); v <= last_v; ++v) {
    for (int u = first_u; u <= last_u; ++u) {
      add(depth(v, u), span);
    }
  }
  return span;
}

}  // namespace

DepthSpan depth_span(const DepthImage& depth, cv::Point pixel, int radius) {
  const bool is_inside = cv::Rect(1, 1, depth.cols - 3, depth.rows - 2).contains(pixel);
  return radius == 1 && is_inside
             ? span_of_neighbours(&depth(pixel), static_cast<std::ptrdiff_t>(depth.step1()))
             : span_within(depth, pixel, radius);
}

}  // namespace vo
