#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include <opencv2/core.hpp>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"

namespace vo {

/// Depth as 16 bit; what they cannot hold is 0, no measurement.
cv::Mat_<std::uint16_t> to_depth_units(const DepthImage& depth, double units_per_m);

/// m
double farthest_in_16_bit(double units_per_m);

/// The pixels that `to_depth_units` loses: farther than 65534 units.
std::size_t count_beyond_16_bit(const DepthImage& depth, double units_per_m);

/// The opposite, of a PNG file. Throws Error naming the file unless it has 16 bits and the camera's
/// size.
DepthImage read_depth_png(const std::filesystem::path& path, const RgbdCamera& camera);

/// Throws Error naming the file unless an image has the camera's size.
void require_size(const cv::Mat& image, const PinholeCamera& camera,
                  const std::filesystem::path& path);

}  // namespace vo
