#include "synth/truth/motion_truth.h"

#include <cstddef>
#include <vector>

namespace synth {
namespace {

cv::Point pixel_of(const PointImage& points, std::size_t index) {
  const auto width = static_cast<std::size_t>(points.size.width);
  return {static_cast<int>(index % width), static_cast<int>(index / width)};
}

/// Returns the point's position at the next frame's time in the next camera's frame, m.
Eigen::Vector3d seen_from(const NextView& next, const vo::SE3& T_next_world,
                          const TrianglePoint& point) {
  return T_next_world * next.tracer.position(point);
}

}  // namespace

FlowImage optical_flow(const PointImage& points, const NextView& next) {
  const vo::SE3 T_next_world = next.T_world_camera.inverse();
  FlowImage flow(points.size, cv::Vec2f(kUnknownFlow, kUnknownFlow));
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const TrianglePoint& point = points.points[i];
    if (!point.exists()) {
      continue;
    }
    const Eigen::Vector3d p_next = seen_from(next, T_next_world, point);
    if (next.camera.depth(p_next) > 0) {
      const cv::Point pixel = pixel_of(points, i);
      const Eigen::Vector2d way =
          next.camera.displacement({pixel.x, pixel.y}, next.camera.project(p_next));
      flow(pixel) = {static_cast<float>(way.x()), static_cast<float>(way.y())};
    }
  }
  return flow;
}

cv::Mat_<std::uint8_t> occlusion(const PointImage& points, const NextView& next) {
  constexpr double kTolerance = 1e-5;  // share of the depth, for neighbouring triangles
  const vo::SE3 T_next_world = next.T_world_camera.inverse();
  cv::Mat_<std::uint8_t> fates(points.size, static_cast<std::uint8_t>(PointFate::nothing));
  std::vector<Eigen::Vector3d> rays;
  std::vector<std::size_t> traced;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    if (!points.points[i].exists()) {
      continue;
    }
    const Eigen::Vector3d p_next = seen_from(next, T_next_world, points.points[i]);
    const bool is_inside = next.camera.sees(p_next);
    fates(pixel_of(points, i)) =
        static_cast<std::uint8_t>(is_inside ? PointFate::visible : PointFate::outside);
    if (is_inside) {
      rays.emplace_back(p_next / next.camera.depth(p_next));
      traced.push_back(i);
    }
  }
  const std::vector<TrianglePoint> firsts =
      next.tracer.trace(next.camera, rays, next.T_world_camera);
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const TrianglePoint& point = points.points[traced[i]];
    const TrianglePoint& first = firsts[i];
    const double depth = next.camera.depth(seen_from(next, T_next_world, point));
    const bool is_itself = first.mesh == point.mesh && first.triangle == point.triangle;
    if (first.exists() && !is_itself && first.depth < (1 - kTolerance) * depth) {
      fates(pixel_of(points, traced[i])) = static_cast<std::uint8_t>(PointFate::occluded);
    }
  }
  return fates;
}

cv::Mat_<std::uint8_t> moved_points(const PointImage& points, const PointTracer& tracer,
                                    const PointTracer& other) {
  constexpr double kRounding = 1e-7;  // m
  cv::Mat_<std::uint8_t> moved(points.size, std::uint8_t{0});
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const TrianglePoint& point = points.points[i];
    if (point.exists() && (other.position(point) - tracer.position(point)).norm() > kRounding) {
      moved(pixel_of(points, i)) = 255;
    }
  }
  return moved;
}

}  // namespace synth
