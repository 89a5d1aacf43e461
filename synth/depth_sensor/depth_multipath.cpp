#include "synth/depth_sensor/depth_multipath.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <Eigen/Cholesky>

namespace synth {
namespace {

constexpr float kSameNormal = 0.98F;  // least cosine between normals of one plane
constexpr float kSamePlane = 0.01F;   // greatest distance from a plane, in its depths
constexpr double kLevelling = 0.05;   // px^2, what holds slopes at 0 that few pixels tell of

/// The opaque surfaces that the pixels see, as points and normals of them, m, camera's axes.
struct SeenSurfaces {
  SeenSurfaces(const DepthSight& depth_sight, const vo::CameraModel& camera);

  /// Returns whether two pixels see one plane.
  bool are_level(const cv::Point& a, const cv::Point& b) const {
    const cv::Vec3f& n = sight.beyond_normal(a);
    return sight.beyond(b) > 0 && n.dot(sight.beyond_normal(b)) > kSameNormal &&
           std::abs(n.dot(points(b) - points(a))) < kSamePlane * sight.beyond(a);
  }

  const DepthSight& sight;
  cv::Mat_<cv::Vec3f> points;
};

SeenSurfaces::SeenSurfaces(const DepthSight& depth_sight, const vo::CameraModel& camera)
    : sight(depth_sight), points(depth_sight.beyond.size(), cv::Vec3f(0, 0, 0)) {
  for (int v = 0; v < points.rows; ++v) {
    for (int u = 0; u < points.cols; ++u) {
      if (sight.beyond(v, u) > 0) {
        const Eigen::Vector3d p = static_cast<double>(sight.beyond(v, u)) * camera.ray({u, v});
        points(v, u) = cv::Vec3d(p.x(), p.y(), p.z());
      }
    }
  }
}

/// Sums of the normal equations of the weighted fit of two linear functions of place.
struct LinearFit {
  void add(const cv::Point& offset, double weight, const cv::Vec2d& weighted_value) {
    const Eigen::Vector3d place(1, offset.x, offset.y);
    A += weight * place * place.transpose();
    b += place * Eigen::RowVector2d(weighted_value[0], weighted_value[1]);
  }

  /// Returns the functions' values at the origin; requires a weight above 0.
  std::complex<double> at_origin() const {
    Eigen::Matrix3d levelled = A;
    levelled(1, 1) += kLevelling * A(0, 0);
    levelled(2, 2) += kLevelling * A(0, 0);
    const Eigen::Matrix<double, 3, 2> fitted = levelled.ldlt().solve(b);
    return {fitted(0, 0), fitted(0, 1)};
  }

  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> b = Eigen::Matrix<double, 3, 2>::Zero();
};

/// Returns the weight of a pixel this far off in a window, by Epanechnikov's kernel.
double window_weight(const cv::Point& offset, int radius) {
  const double edge = radius + 1.0;
  return std::max(0.0, 1 - offset.dot(offset) / (edge * edge));
}

/// Returns the phasor of all light that a pixel sees, in any unit; the phase of the straight light
/// is 0. Where no pixel of the window tells of it, as beside a triangle without area, which has no
/// normal, or where no light returns straight, it is that of the pixel's own paths.
std::complex<double> phasor_at(const cv::Point& pixel, const SeenSurfaces& seen, int radius) {
  const DepthSight& sight = seen.sight;
  const cv::Rect window(pixel.x - radius, pixel.y - radius, 2 * radius + 1, 2 * radius + 1);
  const cv::Rect inside = window & cv::Rect({0, 0}, seen.points.size());
  LinearFit fit;
  for (int v = inside.y; v < inside.br().y; ++v) {
    for (int u = inside.x; u < inside.br().x; ++u) {
      const cv::Point offset = cv::Point(u, v) - pixel;
      const double weight = window_weight(offset, radius);
      if (weight > 0 && seen.are_level(pixel, {u, v})) {
        fit.add(offset, weight * sight.beyond_returned(v, u),
                weight * cv::Vec2d(sight.multipath(v, u)));
      }
    }
  }
  if (fit.A(0, 0) > 0) {
    return 1.0 + fit.at_origin();
  }
  const cv::Vec2f& other = sight.multipath(pixel);
  return {sight.beyond_returned(pixel) + other[0], other[1]};
}

/// Returns the depth that is measured of a surface at a depth, m; 0 if it is lost.
float measured_depth(float depth, double distance, double detour, double max_error) {
  const bool is_lost = detour <= -distance || (max_error > 0 && std::abs(detour) > max_error);
  return is_lost ? 0 : depth * static_cast<float>(1 + detour / distance);
}

/// Puts a depth into a view; where it is 0, there is no surface.
void put(const cv::Point& pixel, float depth, vo::DepthImage& depths,
         cv::Mat_<cv::Vec3f>& normals) {
  depths(pixel) = depth;
  if (depth == 0) {
    normals(pixel) = cv::Vec3f(0, 0, 0);
  }
}

/// Returns the frame with images of depth and normals that it shares with no other.
RenderedFrame with_own_surfaces(const RenderedFrame& frame) {
  RenderedFrame result = frame;
  result.depth = frame.depth.clone();
  result.normal = frame.normal.clone();
  result.sight.beyond = frame.sight.beyond.clone();
  result.sight.beyond_normal = frame.sight.beyond_normal.clone();
  return result;
}

}  // namespace

RenderedFrame with_multipath(const RenderedFrame& frame, const vo::CameraModel& camera,
                             const MultipathOptions& options) {
  if (frame.sight.multipath.empty()) {
    return frame;
  }
  RenderedFrame result = with_own_surfaces(frame);
  DepthSight& sight = result.sight;
  const SeenSurfaces seen(frame.sight, camera);
  for (int v = 0; v < seen.points.rows; ++v) {
    for (int u = 0; u < seen.points.cols; ++u) {
      const cv::Point pixel(u, v);
      if (!(frame.sight.beyond(pixel) > 0)) {
        continue;
      }
      const double detour =
          std::arg(phasor_at(pixel, seen, options.radius)) / (2 * options.wave_number());
      const float depth = measured_depth(frame.sight.beyond(pixel), cv::norm(seen.points(pixel)),
                                         detour, options.max_error);
      put(pixel, depth, sight.beyond, sight.beyond_normal);
      if (static_cast<FirstSurface>(sight.first(pixel)) == FirstSurface::opaque) {
        put(pixel, depth, result.depth, result.normal);
      }
    }
  }
  return result;
}

}  // namespace synth
