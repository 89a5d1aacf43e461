#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Opens a trajectory of TartanAir (Wang et al., IROS 2020), its left camera:
/// image_left/000000_left.png, depth_left/000000_left_depth.npy (float32, m, along the optical
/// axis), which may be absent, and pose_left.txt with `tx ty tz qx qy qz qw` for each image. Its
/// camera has x forward, y right and z down, and so has its world; both become x right, y down, z
/// forward. Frames are 0.1 s apart and have no stamps. The camera is `camera`, else that of
/// camera.toml, which is this project's addition, else the data set's, 640x480 px with a focal
/// length of 320 px.
SequenceSource open_tartanair(const std::filesystem::path& folder,
                              const std::optional<RgbdCamera>& camera);

/// Encodes a frame's image and, if it has depth, its depth as files.
std::vector<NamedBytes> encode_tartanair_frame(std::size_t index, const RgbdFrame& frame);

/// Encodes all files but those of the frames: camera.toml and, if there is ground truth,
/// pose_left.txt, for which every frame needs a pose.
std::vector<NamedBytes> encode_tartanair_lists(const SequenceSource& source);

}  // namespace vo
