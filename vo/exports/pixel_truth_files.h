#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/files/output.h"

namespace vo {

/// A channel of exact ground truth that `edvo render --channels` leaves beside a sequence in TUM's
/// layout: truth/NAME/000000.EXT of each frame, or truth/NAME.csv or truth/labels.json of all.
struct TruthChannelFiles {
  std::string name;
  std::vector<std::filesystem::path> files;  ///< by frame, the last of which may lack one; or one
};

/// Returns the channels of a folder, sorted by name; none if it has no truth/. truth/imu_states.csv
/// is the IMU's and is not among them.
std::vector<TruthChannelFiles> truth_channels_in(const std::filesystem::path& folder);

/// Returns whether a channel's files are those of `frames` frames, one each from 0.
bool is_of_frames(const TruthChannelFiles& channel, std::size_t frames);

/// Reads the files of a channel that are of a frame; with index 0 also those of all frames. Their
/// names are as in the folder that they were read from.
std::vector<NamedBytes> read_truth_of_frame(const TruthChannelFiles& channel, std::size_t index);

}  // namespace vo
