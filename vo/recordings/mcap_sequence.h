#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "vo/core/progress.h"
#include "vo/files/output.h"
#include "vo/frames/sequence_frames.h"
#include "vo/recording_files/mcap_writer.h"

namespace vo {

/// Whether a cloud of the points of each depth image is written, too.
enum class PointClouds { none, written };

/// Throws Error, naming the sequence's `place`, for stamps that a message of ROS 2 does not hold:
/// below 0 or of more than 31 bits of seconds.
void require_mcap_stamps(const SequenceSource& source, const std::string& place);

/// Writes a sequence as an MCAP file of ROS 2: images as they are (bgr8, mono8), depth in mm of 16
/// bits where those hold it exactly, else in m as floats, CameraInfo, and the truth as PoseStamped
/// and as /tf from `world` to the camera. The file appears when it is complete. Read-out and depth
/// noise of the camera and IMU samples have no place in it. Requires `require_mcap_stamps`. Throws
/// Error as StreamedOutput does.
void write_mcap_sequence(const std::filesystem::path& path, const SequenceSource& source,
                         const McapLayout& layout, PointClouds clouds, const OutputPolicy& policy,
                         const Progress& progress);

}  // namespace vo
