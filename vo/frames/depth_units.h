#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/geometry/camera_model.h"

namespace vo {

/// Returns depth, m, in 16-bit units; what they cannot hold becomes 0, which is no measurement.
cv::Mat_<std::uint16_t> to_depth_units(const DepthImage& depth, double units_per_m);

/// Returns depth, m, of 16-bit units; 0 and 65535 become 0, which is no measurement.
DepthImage from_depth_units(const cv::Mat_<std::uint16_t>& units, double units_per_m);

/// Returns the greatest depth that 16-bit units hold, m.
double farthest_in_16_bit(double units_per_m);

/// Returns the number of pixels farther than 65534 units, which `to_depth_units` sets to 0.
std::size_t count_beyond_16_bit(const DepthImage& depth, double units_per_m);

/// Reads depth, m, from a 16-bit PNG; 0 and 65535 become 0, which is no measurement. Throws Error
/// naming the file unless it has 16 bits and the camera's size.
DepthImage read_depth_png(const std::filesystem::path& path, const RgbdCameraModel& camera);

/// Throws Error naming the file unless an image has the camera's size.
void require_size(const cv::Mat& image, const CameraModel& camera,
                  const std::filesystem::path& path);

}  // namespace vo
