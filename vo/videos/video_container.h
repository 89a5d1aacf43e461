#pragma once

#include <filesystem>
#include <optional>

namespace vo {

/// The containers of video files that are read, by their first bytes.
enum class VideoContainer {
  avi,       ///< Microsoft's AVI
  matroska,  ///< Matroska and WebM: .mkv, .webm
  mp4,       ///< MPEG-4 and QuickTime: .mp4, .mov
};

/// Returns the container of a regular file; nothing for another file or none.
std::optional<VideoContainer> video_container(const std::filesystem::path& path);

/// Returns whether a video file ends before its container says that it does, or before its index:
/// what is left of a copy, a download or a recording that was interrupted. A file that has none of
/// these containers is not cut.
bool is_cut(const std::filesystem::path& path);

}  // namespace vo
