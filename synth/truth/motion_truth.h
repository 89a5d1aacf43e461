#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/ray_tracing/point_tracer.h"
#include "vo/geometry/camera_model.h"
#include "vo/geometry/se3.h"

namespace synth {

/// Forward optical flow (du, dv), px: from a pixel's centre to its point in the next frame, in an
/// image that wraps (CameraModel::displacement) by the shorter way round.
using FlowImage = cv::Mat_<cv::Vec2f>;

inline constexpr float kUnknownFlow = 1e10F;  ///< no flow; unknown is above 1e9 as in Middlebury

/// The view of the next frame: the scene at its time and the camera at its pose.
struct NextView {
  const PointTracer& tracer;
  vo::CameraModel camera;
  vo::SE3 T_world_camera;
};

/// Returns optical flow, unknown where nothing was hit or the point is behind the next camera.
FlowImage optical_flow(const PointImage& points, const NextView& next);

/// The visibility of a pixel's point in the next frame, as grey levels of an image.
enum class PointFate : std::uint8_t {
  visible = 0,     ///< visible in the next frame
  nothing = 64,    ///< the pixel sees nothing
  outside = 128,   ///< beyond the next frame's border or behind its camera
  occluded = 255,  ///< occluded by another surface in the next frame
};

/// Returns each pixel's PointFate, found by tracing a ray from the next camera to each point.
cv::Mat_<std::uint8_t> occlusion(const PointImage& points, const NextView& next);

/// Returns 255 where a point's world position at `other`'s time differs by more than rounding.
cv::Mat_<std::uint8_t> moved_points(const PointImage& points, const PointTracer& tracer,
                                    const PointTracer& other);

}  // namespace synth
