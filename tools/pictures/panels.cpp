#include "tools/pictures/panels.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "tools/pictures/pictures.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/image/view_grid.h"
#include "vo/tracking/tracker.h"

namespace tools {
namespace {

using Picture = cv::Mat_<cv::Vec3b>;

const cv::Scalar kInk(30, 30, 30);
const cv::Scalar kPaper(255, 255, 255);

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

/// Draws the image with the tiles in red that move by themselves.
Picture draw_moving(const cv::Mat& image, const vo::TileMask& moving) {
  Picture picture = as_picture(image);
  const vo::ViewTiles grid({.width = picture.cols, .height = picture.rows});
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      if (moving[grid.of({u, v})]) {
        picture(v, u) = picture(v, u) / 2 + cv::Vec3b(0, 0, 127);
      }
    }
  }
  return picture;
}

std::string metres(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f m", value);
  return text.data();
}

/// Draws near bright, far dark and missing depth grey; the bar on the right is labelled in metres.
Picture draw_depth(const vo::DepthImage& depth) {
  const auto [nearest, farthest] = positive_range(depth);
  vo::DepthImage with_bar = depth.clone();
  const int bar_left = depth.cols - depth.cols / 32;
  for (int v = 0; v < depth.rows; ++v) {
    with_bar.row(v).colRange(bar_left, depth.cols) =
        nearest + (farthest - nearest) * v / depth.rows;
  }
  Picture picture = draw_values(with_bar, {farthest, nearest});
  put_line(picture, metres(nearest), bar_left - 60, 16, 0.45);
  put_line(picture, metres(farthest), bar_left - 60, depth.rows - 8, 0.45);
  return picture;
}

Picture draw_figures(const vo::TrackingResult& result, cv::Size size) {
  const vo::AlignResult& alignment = result.alignment;
  const Eigen::Vector3d t = result.T_world_camera.translation();
  std::array<char, 80> time{};
  std::snprintf(time.data(), time.size(), "time %.6f s", result.timestamp);
  std::array<char, 80> position{};
  std::snprintf(position.data(), position.size(), "position %.3f %.3f %.3f m", t.x(), t.y(), t.z());
  std::array<char, 80> correlation{};
  std::snprintf(correlation.data(), correlation.size(),
                "correlation %.4f, %.1f %% of points in view", alignment.correlation,
                100 * alignment.visible_fraction);
  const std::vector<std::string> lines = {
      time.data(),
      "status " + std::string(vo::to_string(result.status)) +
          (result.is_keyframe ? ", keyframe" : ""),
      "ended: " + std::string(vo::to_string(alignment.termination)),
      vo::concat(alignment.points, " points, ", alignment.iterations, " iterations"),
      vo::concat(std::lround(100 * result.moving_fraction), " % of the view moves by itself"),
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
  const vo::EdgePointLevel points = aligned_points(tracker, result, 0);
  return montage(
      {{titled(draw_moving(frame.image, tracker.segmentation().moving()), "image, red: moves"),
        titled(draw_edges(level), "edges"), titled(draw_depth(frame.depth), "depth")},
       {titled(draw_residuals(points, level, result.T_cur_ref_guess), "residual before"),
        titled(draw_residuals(points, level, result.alignment.T_cur_ref), "residual after"),
        draw_figures(result, level.intensity.size())}});
}

}  // namespace tools
