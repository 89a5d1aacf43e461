#include "synth/depth_sensor/depth_holes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synth/depth_sensor/gaussian.h"
#include "vo/core/random_field.h"

namespace synth {
namespace {

constexpr std::uint64_t kHoles = 0x401e;
constexpr std::uint64_t kFlying = 0xf17e;

/// Marks the pixels of a row that a second view to the right sees, from right to left.
void mark_seen(const float* depth, int width, double focal_baseline, bool framed, uchar* seen) {
  double leftmost = std::numeric_limits<double>::infinity();
  for (int u = width - 1; u >= 0; --u) {
    if (!vo::has_depth(depth[u])) {
      continue;
    }
    const double place = u - focal_baseline / depth[u];
    const bool in_frame = !framed || place >= -0.5;
    seen[u] = place < leftmost && in_frame ? 255 : 0;
    leftmost = std::min(leftmost, place);
  }
}

/// Returns the chance that a pixel is lost, 0 to 1.
double loss(const DepthView& view, const vo::CameraModel& camera, const DepthHoles& holes,
            const cv::Point& pixel) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  double lost = 0;
  if (holes.max_incidence_deg < 90) {
    const double angle = kDegrees * incidence(view, camera, pixel);
    const double ramp =
        holes.max_incidence_deg - std::min(holes.sure_incidence_deg, holes.max_incidence_deg);
    lost = angle >= holes.max_incidence_deg ? 1
           : ramp > 0 ? std::max(0.0, 1 - (holes.max_incidence_deg - angle) / ramp)
                      : 0;
  }
  if (holes.max_step > 0 || holes.edge_loss > 0) {
    const DepthSpan span = span_around(view.depth, pixel);
    const bool torn = holes.max_step > 0 && span.farthest - span.nearest > holes.max_step;
    lost = torn ? 1 : span.is_edge() ? std::max(lost, holes.edge_loss) : lost;
  }
  return lost;
}

/// Returns the cumulative distribution function of the standard normal distribution.
double normal_share(double value) {
  return std::erfc(-value / std::numbers::sqrt2) / 2;
}

}  // namespace

DepthSpan span_around(const vo::DepthImage& depth, const cv::Point& pixel) {
  DepthSpan span;
  for (int v = std::max(pixel.y - 1, 0); v <= std::min(pixel.y + 1, depth.rows - 1); ++v) {
    for (int u = std::max(pixel.x - 1, 0); u <= std::min(pixel.x + 1, depth.cols - 1); ++u) {
      const float value = depth(v, u);
      if (vo::has_depth(value)) {
        span.nearest = span.nearest > 0 ? std::min(span.nearest, value) : value;
        span.farthest = std::max(span.farthest, value);
      }
    }
  }
  return span;
}

cv::Mat_<uchar> seen_from_beside(const vo::DepthImage& depth, double focal_px, double baseline,
                                 bool framed) {
  cv::Mat_<uchar> seen(depth.size(), uchar{0});
  vo::DepthImage towards = depth;
  if (baseline < 0) {
    cv::flip(depth, towards, 1);
  }
  for (int v = 0; v < depth.rows; ++v) {
    mark_seen(towards[v], depth.cols, focal_px * std::abs(baseline), framed, seen[v]);
  }
  if (baseline < 0) {
    cv::flip(seen, seen, 1);
  }
  return seen;
}

vo::DepthImage with_holes(const vo::DepthImage& measured, const DepthView& view,
                          const vo::CameraModel& camera, const DepthHoles& holes,
                          std::uint64_t frame) {
  vo::DepthImage result = measured.clone();
  if (holes.second_view != 0) {
    const cv::Mat_<uchar> seen =
        seen_from_beside(view.depth, camera.pinhole_for("sensor.depth.holes.second_view").fx,
                         holes.second_view, holes.second_view_framed);
    result.setTo(0, seen == 0);
  }
  if (holes.max_incidence_deg >= 90 && holes.max_step == 0 && holes.edge_loss == 0) {
    return result;
  }
  const cv::Mat_<float> normals =
      noise_image(measured.size(), holes.correlation, {holes.seed, kHoles, frame});
  for (int v = 0; v < result.rows; ++v) {
    for (int u = 0; u < result.cols; ++u) {
      if (vo::has_depth(result(v, u)) &&
          normal_share(normals(v, u)) < loss(view, camera, holes, {u, v})) {
        result(v, u) = 0;
      }
    }
  }
  return result;
}

vo::DepthImage with_flying_pixels(const vo::DepthImage& measured, const vo::DepthImage& exact,
                                  const FlyingPixels& flying, std::uint64_t frame) {
  if (flying.share == 0) {
    return measured;
  }
  const vo::RandomField random(flying.seed, kFlying, frame);
  vo::DepthImage result = measured.clone();
  for (int v = 0; v < result.rows; ++v) {
    for (int u = 0; u < result.cols; ++u) {
      const DepthSpan span = span_around(exact, {u, v});
      if (vo::has_depth(result(v, u)) && span.is_edge() && random.uniform(u, v) < flying.share) {
        const auto between = static_cast<float>(random.uniform(u, v, 1));
        result(v, u) = span.nearest + between * (span.farthest - span.nearest);
      }
    }
  }
  return result;
}

vo::DepthImage without_dark(const vo::DepthImage& depth, const vo::ColorImage& image,
                            double level) {
  vo::DepthImage result = depth.clone();
  if (level > 0) {
    result.setTo(0, vo::to_gray(image) < level / 255);
  }
  return result;
}

}  // namespace synth
