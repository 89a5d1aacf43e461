#pragma once

#include <filesystem>
#include <vector>

#include "vo/files/numbered_files.h"
#include "vo/geometry/trajectory.h"

namespace vo {

/// The files of a frame.
struct FrameFiles {
  double timestamp = 0;  ///< s
  std::filesystem::path image;
  std::filesystem::path depth;  ///< empty where there is none
};

/// Pairs images with the depth of the same number; stamps are the numbers over `rate`, Hz. Throws
/// Error naming an image without depth where others have some, and for a number beyond the greatest
/// stamp.
std::vector<FrameFiles> paired_files(const std::vector<NumberedFile>& images,
                                     const std::vector<NumberedFile>& depths, double rate);

/// Returns the poses of those files whose number an image has, read by `read_pose_matrix`.
Trajectory poses_of_images(const std::vector<NumberedFile>& poses,
                           const std::vector<NumberedFile>& images, double rate);

/// Returns the stamps of frames, s.
std::vector<double> stamps_of(const std::vector<FrameFiles>& frames);

}  // namespace vo
