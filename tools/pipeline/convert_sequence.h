#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "vo/core/camera.h"
#include "vo/core/progress.h"
#include "vo/io/output.h"
#include "vo/io/sequence_source.h"

namespace tools {

struct ConvertJob {
  std::filesystem::path in;
  std::optional<vo::SequenceFormat> from;  ///< found out without it
  std::optional<vo::RgbdCamera> camera;    ///< instead of the folder's own
  std::filesystem::path out;
  vo::SequenceFormat to = vo::SequenceFormat::tum;
};

struct ConvertOutcome {
  vo::SequenceFormat from = vo::SequenceFormat::tum;
  std::size_t frames = 0;
  std::size_t poses = 0;
  std::size_t imu_samples = 0;
  std::size_t depth_beyond_16_bit = 0;  ///< pixels that became 0
};

/// Writes a sequence in another format, into a folder that appears when it is complete.
ConvertOutcome convert_sequence(const ConvertJob& job, vo::ExistingOutput existing,
                                const vo::Progress& progress);

}  // namespace tools
