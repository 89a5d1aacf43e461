#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "vo/frames/sequence_frames.h"
#include "vo/geometry/camera.h"

namespace vo {

/// Opens the images of a video file as a sequence without depth and truth. `camera` must be given:
/// a video says nothing of its lens. The file is gone through once, to find its frames, and is not
/// kept in memory; frames that are asked for in their order are decoded one after the other,
/// and going back decodes from the beginning, so that a frame is the same in whatever order they
/// are read. Images are as they are stored, also where the file says that players turn them.
///
/// Stamps are the container's times of presentation, to 1 ns; where those do not increase, the
/// frame's number by the stated rate. `notes` say which, and what was cut off. Throws Error naming
/// the file: where it has no video that can be decoded, no frame, or none of the camera's size.
SequenceSource open_video(const std::filesystem::path& file,
                          const std::optional<RgbdCamera>& camera);

/// Returns the stamps of a video's frames, s, as `open_video` does.
std::vector<double> video_stamps(const std::filesystem::path& file);

}  // namespace vo
