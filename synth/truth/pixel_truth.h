#pragma once

#include <opencv2/core.hpp>

#include "synth/ray_tracing/point_tracer.h"
#include "synth/rendering/renderer.h"
#include "vo/core/image.h"

namespace synth {

/// Planar depth at pixel centres, m; 0 = nothing hit. However far, and whatever a sensor measures.
vo::DepthImage depth_truth(const PointImage& points);

/// Of the triangle, unit, world axes, towards the camera; 0 where nothing was hit.
cv::Mat_<cv::Vec3f> normal_truth(const PointImage& points, const PointTracer& tracer,
                                 const Eigen::Vector3d& eye);

/// As SurfaceIds says; 0 where nothing was hit. Throw vo::Error beyond 65535.
IdImage instance_truth(const PointImage& points, const WorldGeometry& world);
IdImage material_truth(const PointImage& points, const WorldGeometry& world);

}  // namespace synth
