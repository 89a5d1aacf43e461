#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "vo/core/progress.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"

namespace vo {

struct ConvertJob {
  std::filesystem::path in;
  std::optional<SequenceFormat> from;  ///< detected from the folder if absent
  std::optional<RgbdCamera> camera;    ///< replaces the camera that the folder holds
  std::filesystem::path out;
  SequenceFormat to = SequenceFormat::tum;
};

struct ConvertOutcome {
  SequenceFormat from = SequenceFormat::tum;
  std::size_t frames = 0;
  std::size_t poses = 0;
  std::size_t imu_samples = 0;
  std::size_t depth_beyond_16_bit = 0;  ///< depth pixels too far for 16 bits, written as 0
  std::vector<std::string> notes;       ///< of the sequence that was read
};

/// Converts a sequence to another format, in a folder that appears only when it is complete.
ConvertOutcome convert_sequence(const ConvertJob& job, const OutputPolicy& policy,
                                const Progress& progress);

}  // namespace vo
