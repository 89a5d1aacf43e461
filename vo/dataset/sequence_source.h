#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/imu.h"
#include "vo/geometry/trajectory.h"

namespace vo {

enum class SequenceFormat {
  tum,       ///< vo/dataset/sequence.h
  euroc,     ///< vo/dataset/euroc.h
  icl_nuim,  ///< vo/dataset/icl_nuim.h: as rendered
  icl_tum,   ///< vo/dataset/icl_nuim.h: the "TUM compatible" files
};

constexpr auto enum_names(SequenceFormat) {
  return std::array{std::pair{SequenceFormat::tum, "tum"},
                    std::pair{SequenceFormat::euroc, "euroc"},
                    std::pair{SequenceFormat::icl_nuim, "icl-nuim"},
                    std::pair{SequenceFormat::icl_tum, "icl-tum"}};
}

/// A sequence on disk, whatever its format. The camera is x right, y down, z forward, the world
/// right-handed; readers of formats that have it otherwise turn it round.
struct SequenceSource {
  RgbdCamera camera;
  std::vector<double> timestamps;                    ///< s, of the frames, increasing
  std::function<RgbdFrame(std::size_t index)> read;  ///< from any thread; depth is empty if absent
  Trajectory truth;                                  ///< T_world_camera; empty if absent
  ImuRecord imu;                                     ///< of a body; empty if absent
  SE3 T_body_camera;
};

/// Throws Error unless the folder holds a sequence of a known format.
SequenceFormat detect_format(const std::filesystem::path& folder);

/// `camera` takes precedence over the folder's own.
SequenceSource open_sequence(const std::filesystem::path& folder, SequenceFormat format,
                             const std::optional<RgbdCamera>& camera = std::nullopt);

}  // namespace vo
