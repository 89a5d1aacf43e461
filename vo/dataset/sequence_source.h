#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/image.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/imu.h"
#include "vo/geometry/trajectory.h"

namespace vo {

enum class SequenceFormat {
  tum,           ///< TUM RGB-D, vo/dataset/sequence.h
  euroc,         ///< EuRoC MAV, vo/dataset/euroc.h
  icl_nuim,      ///< ICL-NUIM as rendered, vo/dataset/icl_nuim.h
  icl_tum,       ///< ICL-NUIM's "TUM compatible" files, vo/dataset/icl_nuim.h
  seven_scenes,  ///< Microsoft's 7-Scenes, vo/dataset/seven_scenes.h
  scannet,       ///< ScanNet as its SensReader exports it, vo/dataset/scannet.h
  open3d,        ///< folders of Open3D and Redwood, vo/dataset/open3d.h
  tartanair,     ///< TartanAir, vo/dataset/tartanair.h
};

constexpr auto enum_names(SequenceFormat) {
  return std::array{std::pair{SequenceFormat::tum, "tum"},
                    std::pair{SequenceFormat::euroc, "euroc"},
                    std::pair{SequenceFormat::icl_nuim, "icl-nuim"},
                    std::pair{SequenceFormat::icl_tum, "icl-tum"},
                    std::pair{SequenceFormat::seven_scenes, "7-scenes"},
                    std::pair{SequenceFormat::scannet, "scannet"},
                    std::pair{SequenceFormat::open3d, "open3d"},
                    std::pair{SequenceFormat::tartanair, "tartanair"}};
}

/// A sequence on disk, whatever its format. The camera is x right, y down, z forward, the world
/// right-handed; readers of formats with other conventions convert them.
struct SequenceSource {
  RgbdCamera camera;
  std::vector<double> timestamps;                    ///< s, of the frames, increasing
  std::function<RgbdFrame(std::size_t index)> read;  ///< for any thread; depth is empty if absent
  Trajectory truth;                                  ///< ground truth; empty if absent
  ImuRecord imu;  ///< of the body that carries the camera; empty if absent
  SE3 T_body_camera;
  std::vector<std::string> notes;  ///< sentences on what was not as the format has it
};

/// Returns the format whose files a folder holds; none where they are of no known format.
std::optional<SequenceFormat> known_format(const std::filesystem::path& folder);

/// Returns the format of the sequence in a folder; throws Error unless it is a known one.
SequenceFormat detect_format(const std::filesystem::path& folder);

/// Opens a sequence; `camera` takes precedence over the one in the folder.
SequenceSource open_sequence(const std::filesystem::path& folder, SequenceFormat format,
                             const std::optional<RgbdCamera>& camera = std::nullopt);

}  // namespace vo
