#pragma once

#include <filesystem>

#include <opencv2/core.hpp>

namespace synth {

/// Reads an image of linear light in OpenEXR's format (.exr; openexr.com, "Technical Introduction
/// to OpenEXR") as RGB: its channels R, G and B, or Y for all three, of half or single precision,
/// in any compression but DWA, of the first part. Negative light, which filters leave, is read as
/// 0. Throws vo::Error naming the file and what is wrong with it: other channels, cube maps,
/// subsampled channels, a pixel that is no finite number, damage.
cv::Mat_<cv::Vec3f> read_exr(const std::filesystem::path& path);

}  // namespace synth
