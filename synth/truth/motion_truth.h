#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/ray_tracing/point_tracer.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/se3.h"

namespace synth {

/// (du, dv), px, forward: where the next frame shows the point that a pixel's centre sees.
using FlowImage = cv::Mat_<cv::Vec2f>;

inline constexpr float kUnknownFlow = 1e10F;  ///< Middlebury's files: beyond 1e9 is unknown

/// The view after this one: the same scene at its time, the same camera at its pose.
struct NextView {
  const PointTracer& tracer;
  const vo::PinholeCamera& camera;
  vo::SE3 T_world_camera;
};

/// Unknown where nothing was hit and where the point is not in front of the next camera.
FlowImage optical_flow(const PointImage& points, const NextView& next);

/// What becomes of the point that a pixel's centre sees, as grey levels of an image.
enum class PointFate : std::uint8_t {
  visible = 0,     ///< in the next frame too
  nothing = 64,    ///< there is no point
  outside = 128,   ///< beyond the next frame's border or behind its camera
  occluded = 255,  ///< another surface is in front of it
};

/// Found by tracing a ray from the next camera to each point.
cv::Mat_<std::uint8_t> occlusion(const PointImage& points, const NextView& next);

/// 255 where a point is elsewhere in the world at the other's time, by more than rounding.
cv::Mat_<std::uint8_t> moved_points(const PointImage& points, const PointTracer& tracer,
                                    const PointTracer& other);

}  // namespace synth
