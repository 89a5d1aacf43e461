#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/progress.h"
#include "vo/dataset/sequence_source.h"
#include "vo/exports/sequence_target.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"
#include "vo/recordings/mcap_sequence.h"

namespace vo {

struct ConvertJob {
  std::filesystem::path in;
  std::optional<SequenceFormat> from;  ///< detected from the folder if absent
  std::optional<RgbdCamera> camera;    ///< replaces the camera that the folder holds
  RecordingRequest recorded{};         ///< what is taken of a recording
  std::filesystem::path out;
  WrittenSequence to = WrittenSequence::tum;
  WorldUp up = WorldUp::unknown;  ///< of the world that is written; unknown: the format's own
  McapLayout mcap{};              ///< of an MCAP file
  PointClouds mcap_clouds = PointClouds::none;  ///< in an MCAP file
};

struct ConvertOutcome {
  SequenceFormat from = SequenceFormat::tum;
  std::size_t frames = 0;
  std::size_t poses = 0;
  WorldUp up = WorldUp::unknown;        ///< of the world that was written, if it is known
  std::size_t imu_samples = 0;          ///< that were written
  std::size_t depth_beyond_16_bit = 0;  ///< depth pixels too far for 16 bits, written as 0
  std::vector<std::string> dropped;     ///< what the format cannot hold, as words of a list
  std::vector<std::string> notes;       ///< sentences on the sequence that was read
};

/// Converts a sequence, or the folder of a rig, to another format, in a folder, or of MCAP and
/// videos in a file, that appears only when it is complete.
ConvertOutcome convert_sequence(const ConvertJob& job, const OutputPolicy& policy,
                                const Progress& progress);

}  // namespace vo
