#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "vo/frames/sequence_frames.h"
#include "vo/geometry/camera.h"
#include "vo/recordings/recorded_sequence.h"

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
  mcap,          ///< an MCAP file, or a folder of ROS 2's that holds one, vo/recordings
  bag,           ///< a ROS 1 bag, vo/recordings
  video,         ///< a video file: AVI, Matroska, WebM, MP4, QuickTime, vo/videos
};

constexpr auto enum_names(SequenceFormat) {
  return std::array{std::pair{SequenceFormat::tum, "tum"},
                    std::pair{SequenceFormat::euroc, "euroc"},
                    std::pair{SequenceFormat::icl_nuim, "icl-nuim"},
                    std::pair{SequenceFormat::icl_tum, "icl-tum"},
                    std::pair{SequenceFormat::seven_scenes, "7-scenes"},
                    std::pair{SequenceFormat::scannet, "scannet"},
                    std::pair{SequenceFormat::open3d, "open3d"},
                    std::pair{SequenceFormat::tartanair, "tartanair"},
                    std::pair{SequenceFormat::mcap, "mcap"},
                    std::pair{SequenceFormat::bag, "bag"},
                    std::pair{SequenceFormat::video, "video"}};
}

/// Returns the format whose files a folder holds, or that a file is of; none where that is not
/// known. Throws Error for the folder of a rig, which holds several sequences.
std::optional<SequenceFormat> known_format(const std::filesystem::path& path);

/// The end of the error that refuses a file of no known format, behind its path.
inline constexpr const char* kNoSequenceFile =
    ": is no recording or video, expected an MCAP file, a ROS 1 bag, a video (AVI, MP4, MOV, MKV, "
    "WebM) or the folder of a sequence";

/// Returns the format of the sequence in a folder or file; throws Error unless it is a known one.
SequenceFormat detect_format(const std::filesystem::path& path);

/// Opens a sequence; `camera` takes precedence over the one in the folder. `request` is for
/// recordings; throws Error where it names topics of another format.
SequenceSource open_sequence(const std::filesystem::path& path, SequenceFormat format,
                             const std::optional<RgbdCamera>& camera = std::nullopt,
                             const RecordingRequest& request = {});

}  // namespace vo
