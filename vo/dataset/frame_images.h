#pragma once

#include <filesystem>

#include "vo/core/image.h"
#include "vo/dataset/frame_files.h"
#include "vo/geometry/camera.h"

namespace vo {

/// Reads a frame's image, a PNG, JPEG, PGM or PPM of 8 bits. Throws Error naming the file unless it
/// has the camera's size.
cv::Mat read_frame_image(const std::filesystem::path& path, const PinholeCamera& camera);

/// Reads a frame from its image, as `read_frame_image` does, and its depth, if it has some: a .npy
/// as `read_depth_npy` does, else as `read_depth_png`.
RgbdFrame read_frame(const FrameFiles& files, const RgbdCamera& camera);

/// Reads an image of 8 bits of whatever size. Throws Error naming the file.
cv::Mat read_byte_image(const std::filesystem::path& path);

/// Reads depth, m, from a .npy file of floats; what is not finite or not above 0 becomes 0, which
/// is no measurement. Throws Error naming the file unless it has one channel and the camera's size.
DepthImage read_depth_npy(const std::filesystem::path& path, const PinholeCamera& camera);

}  // namespace vo
