#pragma once

#include <array>
#include <cstddef>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/tracking/tracking_result.h"

namespace vo {
class Tracker;
}  // namespace vo

namespace tools {

/// Returns a grey or colour image as a colour picture (BGR) with its own memory.
cv::Mat_<cv::Vec3b> as_picture(const cv::Mat& image);

/// Returns the least and the greatest value above 0; both are 0 where there is none.
std::array<double, 2> positive_range(const cv::Mat_<float>& values);

/// Returns the values in viridis' colours, the first end of the range dark and the second bright
/// (the range may fall); grey where the value is 0.
cv::Mat_<cv::Vec3b> draw_values(const cv::Mat_<float>& values, std::array<double, 2> range);

/// Returns the residuals at the reference's pixels: blue darker, red brighter than the reference,
/// white equal, yellow not in view, dark grey elsewhere.
cv::Mat_<cv::Vec3b> draw_residuals(const vo::EdgePointLevel& points, const vo::PyramidLevel& level,
                                   const vo::SE3& T_cur_ref);

/// Returns one level of the first reference's points; none where the frame was not aligned.
vo::EdgePointLevel aligned_points(const vo::Tracker& tracker, const vo::TrackingResult& result,
                                  std::size_t level);

}  // namespace tools
