#include "tools/pictures/pictures.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vo/residuals/warp.h"
#include "vo/tracking/tracker.h"

namespace tools {
namespace {

using Picture = cv::Mat_<cv::Vec3b>;

constexpr double kFullResidual = 30.0 / 255;  // residual at which the colour saturates, intensity

cv::Vec3b residual_colour(float residual) {
  const double strength = std::min(std::abs(residual) / kFullResidual, 1.0);
  const auto faded = static_cast<uchar>(255 * (1 - strength));
  return residual > 0 ? cv::Vec3b(faded, faded, 255) : cv::Vec3b(255, faded, faded);
}

}  // namespace

Picture as_picture(const cv::Mat& image) {
  Picture picture;
  if (image.channels() == 1) {
    cv::cvtColor(image, picture, cv::COLOR_GRAY2BGR);
  } else {
    image.copyTo(picture);
  }
  return picture;
}

std::array<double, 2> positive_range(const cv::Mat_<float>& values) {
  std::array<double, 2> range{};
  cv::minMaxLoc(values, &range[0], &range[1], nullptr, nullptr, values > 0);
  return range;
}

Picture draw_values(const cv::Mat_<float>& values, std::array<double, 2> range) {
  const double scale = range[0] == range[1] ? 0 : 255 / (range[1] - range[0]);
  cv::Mat shades;
  values.convertTo(shades, CV_8U, scale, -scale * range[0]);
  Picture picture;
  cv::applyColorMap(shades, picture, cv::COLORMAP_VIRIDIS);
  picture.setTo(cv::Vec3b(128, 128, 128), values == 0);
  return picture;
}

cv::Mat_<cv::Vec3b> draw_residuals(const vo::EdgePointLevel& points, const vo::PyramidLevel& level,
                                   const vo::SE3& T_cur_ref) {
  Picture picture(level.intensity.size(), cv::Vec3b(40, 40, 40));
  const auto residuals = vo::residuals(points, level, T_cur_ref);
  for (std::size_t i = 0; i < points.size(); ++i) {
    picture(points.pixel[i]) =
        residuals[i] ? residual_colour(*residuals[i]) : cv::Vec3b(0, 120, 120);
  }
  return picture;
}

vo::EdgePointLevel aligned_points(const vo::Tracker& tracker, const vo::TrackingResult& result,
                                  std::size_t level) {
  const std::vector<vo::EdgePointLevel>& levels = tracker.reference_points().levels;
  const bool aligned = result.status != vo::TrackingStatus::initialized && level < levels.size();
  return aligned ? levels[level] : vo::EdgePointLevel{};
}

}  // namespace tools
