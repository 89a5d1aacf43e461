#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "synth/point_tracer.h"
#include "vo/core/image.h"

namespace synth {

using IdImage = cv::Mat_<std::uint16_t>;

/// Planar depth at pixel centres, m; 0 = nothing hit. However far, and whatever a sensor measures.
vo::DepthImage depth_truth(const PointImage& points);

/// Of the triangle, unit, world axes, towards the camera; 0 where nothing was hit.
cv::Mat_<cv::Vec3f> normal_truth(const PointImage& points, const PointTracer& tracer,
                                 const Eigen::Vector3d& eye);

/// 1 + index in Scene::instances; 0 where nothing was hit. Throws vo::Error beyond 65535.
IdImage instance_truth(const PointImage& points, const FlatScene& flat);

/// 1 + index in Scene::materials; 1 + their number of a mesh without a material; 0 where nothing
/// was hit. Throws vo::Error beyond 65535.
IdImage material_truth(const PointImage& points, const FlatScene& flat);

}  // namespace synth
