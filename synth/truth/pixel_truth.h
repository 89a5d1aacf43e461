#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "synth/ray_tracing/point_tracer.h"
#include "synth/rendering/renderer.h"
#include "vo/core/image.h"

namespace synth {

/// Returns exact depth at pixel centres, m, CameraModel::depth, of any range; 0 = nothing hit.
vo::DepthImage depth_truth(const PointImage& points);

/// Returns unit triangle normals, world axes, towards the camera at `eye`; 0 = nothing hit.
cv::Mat_<cv::Vec3f> normal_truth(const PointImage& points, const PointTracer& tracer,
                                 const Eigen::Vector3d& eye);

/// Returns SurfaceIds::instance, 0 = nothing hit. Throws vo::Error if an id exceeds 65535.
IdImage instance_truth(const PointImage& points, const WorldGeometry& world);
/// Returns SurfaceIds::material, 0 = nothing hit. Throws vo::Error if an id exceeds 65535.
IdImage material_truth(const PointImage& points, const WorldGeometry& world);
/// Returns the class's id of each pixel's instance, of which `instance_classes` has one for each of
/// Scene::instances; 0 = none or nothing hit.
IdImage class_truth(const PointImage& points, const WorldGeometry& world,
                    const std::vector<std::uint16_t>& instance_classes);

}  // namespace synth
