#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/image/pyramid.h"
#include "vo/tracking/tracking_result.h"

namespace vo {
class Tracker;
}  // namespace vo

namespace tools {

/// Returns the picture with a line of text at its top left.
cv::Mat_<cv::Vec3b> titled(cv::Mat_<cv::Vec3b> picture, const std::string& title);

/// Returns rows of pictures, each row below the one before; all pictures have equal size.
cv::Mat_<cv::Vec3b> montage(const std::vector<std::vector<cv::Mat_<cv::Vec3b>>>& rows);

/// Returns a picture of how a frame was tracked: image | edges | depth over residual before |
/// residual after | numbers.
cv::Mat_<cv::Vec3b> draw_panel(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                               const vo::Tracker& tracker, const vo::TrackingResult& result);

}  // namespace tools
