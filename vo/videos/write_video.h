#pragma once

#include <filesystem>
#include <vector>

#include "vo/core/progress.h"
#include "vo/files/output.h"
#include "vo/frames/sequence_frames.h"

namespace vo {

/// Returns the frame rate of a video of frames of these stamps, Hz: their mean one, to 0.001; 30 of
/// a single frame.
double video_rate(const std::vector<double>& timestamps);

/// Returns whether a video keeps these stamps: they begin with 0 and are even to 0.5 ms.
bool video_holds(const std::vector<double>& timestamps);

/// Throws Error of kind usage unless a video can have the name: its end chooses the container and
/// the codec, `.avi` FFV1, which keeps every pixel, `.mp4` MPEG-4 part 2, which does not.
void require_video_name(const std::filesystem::path& path);

/// Writes the images of a sequence as a video, colour or grey as the first one is, which appears
/// when it is complete. It is read back before, its images counted. Throws Error as StreamedOutput
/// does, for images of another size or kind than the first, and for sizes that are not even.
void write_video(const std::filesystem::path& path, const SequenceSource& source,
                 const OutputPolicy& policy, const Progress& progress);

}  // namespace vo
