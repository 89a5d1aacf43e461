#pragma once

#include "vo/core/image.h"

namespace vo {

/// The nearest and the farthest measured depth around a pixel, m.
struct DepthSpan {
  float nearest;
  float farthest;
};

/// Of the pixels at most `radius` away in u and in v. The pixel itself must have depth.
DepthSpan depth_span(const DepthImage& depth, cv::Point pixel, int radius);

}  // namespace vo
