#include "synth/truth/edge_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synth/scene/srgb.h"
#include "vo/core/error.h"

namespace synth {
namespace {

Eigen::Vector3d to_eigen(const cv::Vec3f& pixel) {
  return {pixel[0], pixel[1], pixel[2]};
}

cv::Mat_<cv::Vec3f> encoded(const cv::Mat_<cv::Vec3f>& linear) {
  cv::Mat_<cv::Vec3f> result(linear.size());
  std::transform(linear.begin(), linear.end(), result.begin(), [](const cv::Vec3f& rgb) {
    return cv::Vec3f(encode_srgb(std::clamp(rgb[0], 0.0F, 1.0F)),
                     encode_srgb(std::clamp(rgb[1], 0.0F, 1.0F)),
                     encode_srgb(std::clamp(rgb[2], 0.0F, 1.0F)));
  });
  return result;
}

/// Labels one view by comparing pairs of neighbouring pixels.
class Labeller {
 public:
  Labeller(const SurfaceView& view, const vo::CameraModel& camera, const EdgeLabelOptions& options)
      : view_(view),
        camera_(camera),
        options_(options),
        color_(encoded(view.base_color)),
        least_cosine_(std::cos(options.crease_deg * std::numbers::pi / 180)),
        labels_(view.depth.size(), 0) {}

  EdgeLabels run() {
    for (int v = 0; v < labels_.rows; ++v) {
      for (int u = 0; u < labels_.cols; ++u) {
        label_pair({u, v}, {1, 0});
        label_pair({u, v}, {0, 1});
      }
    }
    return labels_;
  }

 private:
  bool is_inside(const cv::Point& pixel) const {
    return cv::Rect(cv::Point(), labels_.size()).contains(pixel);
  }

  /// Returns the pixel one step on, which may be outside but for columns of an image that wraps.
  cv::Point stepped(const cv::Point& pixel, const cv::Point& step) const {
    const cv::Point there = pixel + step;
    return camera_.wraps() ? cv::Point((there.x + labels_.cols) % labels_.cols, there.y) : there;
  }

  void label_pair(const cv::Point& a, const cv::Point& step) {
    const cv::Point b = stepped(a, step);
    if (!is_inside(b)) {
      return;
    }
    if (has_depth_edge(a, b)) {
      const bool b_is_nearer = vo::has_depth(view_.depth(b)) &&
                               (!vo::has_depth(view_.depth(a)) || view_.depth(b) < view_.depth(a));
      labels_(b_is_nearer ? b : a) |= bit(EdgeCause::depth);
      return;
    }
    if (to_eigen(view_.normal(a)).dot(to_eigen(view_.normal(b))) < least_cosine_ &&
        vo::has_depth(view_.depth(a))) {
      labels_(a) |= bit(EdgeCause::crease);
    }
    if (std::abs(view_.light_share(a) - view_.light_share(b)) >= options_.shadow_step) {
      labels_(a) |= bit(EdgeCause::shadow);
    }
    if (has_albedo_edge(a, b, step)) {
      labels_(a) |= bit(EdgeCause::albedo);
    }
  }

  /// Returns whether the colour changes most between a and b, and enough from one pixel before to
  /// one after.
  bool has_albedo_edge(const cv::Point& a, const cv::Point& b, const cv::Point& step) const {
    const double contrast = color_step(a, b);
    const cv::Point before = stepped(a, -step);
    const cv::Point after = stepped(b, step);
    if (contrast < color_step(before, a) || contrast <= color_step(b, after)) {
      return false;
    }
    return color_step(is_inside(before) ? before : a, is_inside(after) ? after : b) >=
           options_.albedo_step;
  }

  /// Returns whether neither pixel's surface, continued as a plane, explains the other's depth.
  bool has_depth_edge(const cv::Point& a, const cv::Point& b) const {
    const float depth_a = view_.depth(a);
    const float depth_b = view_.depth(b);
    if (!vo::has_depth(depth_a) || !vo::has_depth(depth_b)) {
      return vo::has_depth(depth_a) != vo::has_depth(depth_b);
    }
    const double least = options_.depth_step * std::min(depth_a, depth_b);
    return std::abs(depth_of_plane_at(a, b) - depth_b) > least &&
           std::abs(depth_of_plane_at(b, a) - depth_a) > least;
  }

  /// Returns the depth at which the ray of `to` meets the plane seen at `from`, m.
  double depth_of_plane_at(const cv::Point& from, const cv::Point& to) const {
    const Eigen::Vector3d normal = to_eigen(view_.face_normal(from));
    const double distance = normal.dot(ray(from)) * view_.depth(from);
    const double along_ray = normal.dot(ray(to));
    return along_ray < 0 ? distance / along_ray : std::numeric_limits<double>::infinity();
  }

  Eigen::Vector3d ray(const cv::Point& pixel) const {
    return camera_.ray(Eigen::Vector2d(pixel.x, pixel.y));
  }

  double color_step(const cv::Point& a, const cv::Point& b) const {
    if (!is_inside(a) || !is_inside(b)) {
      return 0;
    }
    return cv::norm(color_(a), color_(b), cv::NORM_INF);
  }

  const SurfaceView& view_;
  const vo::CameraModel& camera_;
  const EdgeLabelOptions& options_;
  cv::Mat_<cv::Vec3f> color_;  ///< sRGB-encoded base colour
  double least_cosine_;        ///< least cosine between normals without a crease
  EdgeLabels labels_;
};

}  // namespace

void EdgeLabelOptions::validate() const {
  vo::require(depth_step > 0, "labels.depth_step: expected above 0, got ", depth_step);
  vo::require(crease_deg > 0 && crease_deg < 180, "labels.crease_deg: expected 0 to 180, got ",
              crease_deg);
  vo::require(albedo_step > 0, "labels.albedo_step: expected above 0, got ", albedo_step);
  vo::require(shadow_step > 0, "labels.shadow_step: expected above 0, got ", shadow_step);
}

EdgeLabels edge_labels(const SurfaceView& view, const vo::CameraModel& camera,
                       const EdgeLabelOptions& options) {
  return Labeller(view, camera, options).run();
}

}  // namespace synth
