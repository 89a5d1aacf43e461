#include "synth/path_planning/view_content.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "synth/scene/srgb.h"

namespace synth {
namespace {

constexpr int kTile = 4;                 // px
constexpr double kLeastContrast = 0.08;  // least range of encoded grey in a textured tile

/// Returns the sRGB-encoded Rec. 709 luminance of the base colour times the share of light.
cv::Mat_<float> grey_of(const SurfaceView& view) {
  cv::Mat_<float> grey(view.depth.size());
  for (int v = 0; v < grey.rows; ++v) {
    for (int u = 0; u < grey.cols; ++u) {
      const cv::Vec3f& color = view.base_color(v, u);
      const float luminance = 0.2126F * color[0] + 0.7152F * color[1] + 0.0722F * color[2];
      grey(v, u) = encode_srgb(std::clamp(luminance * view.light_share(v, u), 0.0F, 1.0F));
    }
  }
  return grey;
}

bool is_textured(const cv::Mat& grey, const cv::Mat& depth, double reach) {
  double darkest = 0;
  double brightest = 0;
  double nearest = 0;
  cv::minMaxLoc(grey, &darkest, &brightest);
  cv::minMaxLoc(depth, &nearest, nullptr);
  return brightest - darkest > kLeastContrast && nearest > 0 && cv::mean(depth)[0] < reach;
}

}  // namespace

ViewContent view_content(const SurfaceTracer& tracer, const vo::CameraModel& camera,
                         const vo::SE3& T_world_camera, double reach) {
  const SurfaceView view = tracer.trace(camera, T_world_camera);
  const cv::Mat_<float> grey = grey_of(view);
  ViewContent content;
  const cv::Mat hit = view.depth > 0;
  content.depth_share =
      static_cast<double>(cv::countNonZero(hit)) / static_cast<double>(view.depth.total());
  if (content.depth_share > 0) {
    cv::minMaxLoc(view.depth, &content.nearest, nullptr, nullptr, nullptr, hit);
  }
  int tiles = 0;
  int textured = 0;
  for (int v = 0; v + kTile <= grey.rows; v += kTile) {
    for (int u = 0; u + kTile <= grey.cols; u += kTile) {
      const cv::Rect tile(u, v, kTile, kTile);
      ++tiles;
      textured += is_textured(grey(tile), view.depth(tile), reach) ? 1 : 0;
    }
  }
  content.textured_share = tiles > 0 ? static_cast<double>(textured) / tiles : 0;
  return content;
}

vo::CameraModel thumbnail(const vo::CameraModel& camera, int width) {
  const double scale = static_cast<double>(width) / camera.width();
  const int height = std::max(1, static_cast<int>(std::lround(camera.height() * scale)));
  const vo::PinholeCamera* const pinhole = camera.pinhole();
  if (pinhole == nullptr) {
    return camera.resized(width, height);
  }
  vo::PinholeCamera small = *pinhole;
  small.width = width;
  small.height = height;
  small.fx *= scale;
  small.fy *= scale;
  small.cx = (pinhole->cx + 0.5) * scale - 0.5;
  small.cy = (pinhole->cy + 0.5) * scale - 0.5;
  return small;
}

}  // namespace synth
