#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

namespace vo {

/// The images of a video or of a camera, one after the other.
struct VideoCapture {
  std::function<bool()> grab;      ///< goes to the next image; false where there is none
  std::function<cv::Mat()> image;  ///< CV_8UC3 (BGR), or CV_8UC1 of grey; empty if not decoded
  std::function<double()> stamp;   ///< s, of the image, as the container or the driver has it
  double rate_hz = 0;              ///< as the container states; 0 if it does not
  double stated_frames = 0;        ///< likewise
  bool is_shown_turned = false;    ///< whether the file says so; images are as they are stored
};

/// A video while it is written, images of one size and kind one after the other. What fails on the
/// disk is not reported.
struct VideoEncoder {
  std::function<void(const cv::Mat& image)> write;  ///< CV_8UC3 (BGR) or CV_8UC1
  std::function<void()> finish;                     ///< writes what is left and closes the file
};

/// How a video is encoded.
enum class VideoCodec {
  ffv1,   ///< FFmpeg's lossless one: pixels are kept to the bit
  mpeg4,  ///< MPEG-4 part 2, lossy
};

struct VideoFormat {
  VideoCodec codec = VideoCodec::ffv1;
  double rate_hz = 30;
  cv::Size size;  ///< px, even
  int channels = 3;
};

/// What OpenCV's videoio does for this project. It is a library of its own, loaded when it is asked
/// for: with FFmpeg and GStreamer behind it, it would take 0.3 s from the start of every program.
struct VideoLibrary {
  /// Opens a file; nothing if it has no video that can be decoded.
  std::optional<VideoCapture> (*open_file)(const std::filesystem::path& file);

  /// Opens a camera of Video4Linux2 and asks for a size; nothing if that does not capture.
  std::optional<VideoCapture> (*open_camera)(const std::filesystem::path& device,
                                             const std::optional<cv::Size>& size);

  /// Makes a file, whose container its name's end chooses; nothing without such a codec.
  std::optional<VideoEncoder> (*make_file)(const std::filesystem::path& file,
                                           const VideoFormat& format);

  /// Returns the number of images that a file holds, which are not decoded for it.
  std::size_t (*count_images)(const std::filesystem::path& file);
};

/// The function of the loaded library that returns what it does, if it is of this version.
using VideoLibraryEntry = const VideoLibrary* (*)(const char* version);
inline constexpr const char* kVideoLibraryEntry = "edvo_video_library";

/// Returns the library, loaded by the first call. Throws Error, which begins with `place`, where
/// this program was built without or the system lacks what it needs.
const VideoLibrary& video_library(const std::string& place);

}  // namespace vo
