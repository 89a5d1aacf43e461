#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "vo/core/progress.h"
#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"

namespace vo {

struct ConvertJob {
  std::filesystem::path in;
  std::optional<SequenceFormat> from;  ///< found out without it
  std::optional<RgbdCamera> camera;    ///< instead of the folder's own
  std::filesystem::path out;
  SequenceFormat to = SequenceFormat::tum;
};

struct ConvertOutcome {
  SequenceFormat from = SequenceFormat::tum;
  std::size_t frames = 0;
  std::size_t poses = 0;
  std::size_t imu_samples = 0;
  std::size_t depth_beyond_16_bit = 0;  ///< pixels that became 0
};

/// Writes a sequence in another format, into a folder that appears when it is complete.
ConvertOutcome convert_sequence(const ConvertJob& job, ExistingOutput existing,
                                const Progress& progress);

}  // namespace vo
