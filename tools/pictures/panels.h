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

/// A line of text at the top left of a picture.
cv::Mat_<cv::Vec3b> titled(cv::Mat_<cv::Vec3b> picture, const std::string& title);

/// Pictures beside each other, and rows of them below each other; all have the same size.
cv::Mat_<cv::Vec3b> montage(const std::vector<std::vector<cv::Mat_<cv::Vec3b>>>& rows);

/// One picture of how a frame was tracked: image | edges | depth over residual before | residual
/// after | figures.
cv::Mat_<cv::Vec3b> draw_panel(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                               const vo::Tracker& tracker, const vo::TrackingResult& result);

}  // namespace tools
