#pragma once

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/image/pyramid.h"
#include "vo/tracking/tracker.h"

namespace tools {

/// One picture of how a frame was tracked: image | edges | depth over residual before | residual
/// after | figures. Residuals are drawn at the reference's pixels: blue darker, red brighter than
/// the reference, white equal.
cv::Mat_<cv::Vec3b> draw_panel(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                               const vo::Tracker& tracker, const vo::TrackingResult& result);

}  // namespace tools
