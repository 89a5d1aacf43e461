#include "tools/report/panels.h"

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace tools {
namespace {

using Picture = cv::Mat_<cv::Vec3b>;

constexpr double kFullResidual = 30.0 / 255;  // intensity at which the colour saturates
const cv::Scalar kInk(30, 30, 30);
const cv::Scalar kPaper(255, 255, 255);

Picture as_picture(const cv::Mat& image) {
  Picture picture;
  if (image.channels() == 1) {
    cv::cvtColor(image, picture, cv::COLOR_GRAY2BGR);
  } else {
    image.copyTo(picture);
  }
  return picture;
}

void put_line(Picture& picture, const std::string& text, int x, int y, double size) {
  for (const auto& [colour, thickness] : {std::pair{kPaper, 3}, std::pair{kInk, 1}}) {
    cv::putText(picture, text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, size, colour, thickness,
                cv::LINE_AA);
  }
}

Picture draw_edges(const vo::PyramidLevel& level) {
  cv::Mat gray;
  level.intensity.convertTo(gray, CV_8U, 100, 155);
  Picture picture = as_picture(gray);
  picture.setTo(cv::Vec3b(160, 60, 0), level.edges);
  return picture;
}

std::string metres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f m", value);
  return text.data();
}

/// Near is bright, far is dark, no measurement is grey; the bar on the right carries the metres.
Picture draw_depth(const vo::DepthImage& depth) {
  double nearest = 0;
  double farthest = 0;
  const cv::Mat missing = depth == 0;
  cv::minMaxLoc(depth, &nearest, &farthest, nullptr, nullptr, depth > 0);
  const double scale = farthest > nearest ? 255 / (farthest - nearest) : 0;
  cv::Mat scaled;
  depth.convertTo(scaled, CV_8U, -scale, scale * farthest);
  const int bar_width = depth.cols / 32;
  const int bar_left = depth.cols - bar_width;
  for (int v = 0; v < depth.rows; ++v) {
    const int shade = 255 - 255 * v / depth.rows;
    scaled.row(v).colRange(bar_left, depth.cols) = shade;
  }
  Picture picture;
  cv::applyColorMap(scaled, picture, cv::COLORMAP_VIRIDIS);
  picture.colRange(0, bar_left).setTo(cv::Vec3b(128, 128, 128), missing.colRange(0, bar_left));
  put_line(picture, metres(nearest), bar_left - 60, 16, 0.45);
  put_line(picture, metres(farthest), bar_left - 60, depth.rows - 8, 0.45);
  return picture;
}

cv::Vec3b residual_colour(float residual) {
  const double strength = std::min(std::abs(residual) / kFullResidual, 1.0);
  const auto faded = static_cast<uchar>(255 * (1 - strength));
  return residual > 0 ? cv::Vec3b(faded, faded, 255) : cv::Vec3b(255, faded, faded);
}

Picture draw_figures(const vo::TrackingResult& result, cv::Size size) {
  const vo::AlignResult& alignment = result.alignment;
  const Eigen::Vector3d t = result.T_world_camera.translation();
  std::array<char, 80> position{};
  std::snprintf(position.data(), position.size(), "position %.3f %.3f %.3f m", t.x(), t.y(), t.z());
  std::array<char, 80> correlation{};
  std::snprintf(correlation.data(), correlation.size(),
                "correlation %.4f, %.1f %% of points in view", alignment.correlation,
                100 * alignment.visible_fraction);
  const std::vector<std::string> lines = {
      "time " + vo::concat(result.timestamp) + " s",
      "status " + std::string(vo::to_string(result.status)) +
          (result.is_keyframe ? ", keyframe" : ""),
      "ended: " + std::string(vo::to_string(alignment.termination)),
      vo::concat(alignment.points, " points, ", alignment.iterations, " iterations"),
      correlation.data(),
      position.data(),
      "residuals: red brighter, blue darker than the reference,",
      "yellow not in view"};
  Picture picture(size, cv::Vec3b(255, 255, 255));
  int y = 40;
  for (const std::string& line : lines) {
    put_line(picture, line, 16, y, 0.55);
    y += 32;
  }
  return picture;
}

}  // namespace

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

cv::Mat_<cv::Vec3b> titled(cv::Mat_<cv::Vec3b> picture, const std::string& title) {
  put_line(picture, title, 8, 20, 0.5);
  return picture;
}

cv::Mat_<cv::Vec3b> montage(const std::vector<std::vector<cv::Mat_<cv::Vec3b>>>& rows) {
  std::vector<Picture> joined;
  for (const std::vector<Picture>& row : rows) {
    cv::hconcat(row, joined.emplace_back());
  }
  Picture all;
  cv::vconcat(joined, all);
  return all;
}

Picture draw_panel(const vo::RgbdFrame& frame, const vo::FramePyramid& pyramid,
                   const vo::Tracker& tracker, const vo::TrackingResult& result) {
  const vo::PyramidLevel& level = pyramid.levels.front();
  const vo::EdgePointLevel none;
  const auto& levels = tracker.reference_points().levels;
  const vo::EdgePointLevel& points =
      result.status == vo::TrackingStatus::initialized ? none : levels.front();
  return montage(
      {{titled(as_picture(frame.image), "image"), titled(draw_edges(level), "edges"),
        titled(draw_depth(frame.depth), "depth")},
       {titled(draw_residuals(points, level, result.T_cur_ref_guess), "residual before"),
        titled(draw_residuals(points, level, result.alignment.T_cur_ref), "residual after"),
        draw_figures(result, level.intensity.size())}});
}

}  // namespace tools
