#include "vo/videos/video_sequence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/nanoseconds.h"
#include "vo/frames/depth_units.h"
#include "vo/videos/video_container.h"
#include "vo/videos/video_library.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

VideoCapture open_capture(const fs::path& file) {
  const VideoLibrary& library = video_library(file.string());
  std::optional<VideoCapture> capture = library.open_file(file);
  require(capture.has_value(), file.string(),
          is_cut(file) ? ": is cut before the end that its container states, and cannot be decoded "
                         "without what is missing"
                       : ": has no video that can be decoded, expected one in a codec of FFmpeg's");
  return std::move(*capture);
}

/// What is known of a video once it was gone through.
struct VideoIndex {
  std::vector<double> timestamps;  ///< s
  std::vector<std::string> notes;
};

/// Returns a stamp, s, rounded to 1 ns, so that 0.04 s is what a list of stamps says by `0.04`.
/// The first frame of some files is stamped before the beginning, by the time of its decoding.
double rounded_stamp(double stamp) {
  return std::max(std::round(stamp * kNanosecondsPerSecond) / kNanosecondsPerSecond, 0.0);
}

/// Replaces stamps that do not increase, and notes what they are.
void settle_stamps(const fs::path& file, const VideoCapture& capture, VideoIndex& index) {
  std::vector<double>& stamps = index.timestamps;
  if (std::adjacent_find(stamps.begin(), stamps.end(), std::greater_equal<>()) == stamps.end()) {
    index.notes.emplace_back("the stamps are the container's times of presentation");
    return;
  }
  require(capture.rate_hz > 0, file.string(),
          ": its times of presentation do not increase, and it states no frame rate");
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    stamps[i] = rounded_stamp(static_cast<double>(i) / capture.rate_hz);
  }
  index.notes.push_back(
      concat("the container's times of presentation do not increase: the stamps are the frames' "
             "numbers by its rate of ",
             capture.rate_hz, " Hz"));
}

/// Notes how many frames there are if the container says otherwise. Of a file that is cut, the last
/// one is left out: half of it may be missing, which decoders fill in.
void settle_end(const fs::path& file, const VideoCapture& capture, VideoIndex& index) {
  const std::size_t found = index.timestamps.size();
  if (is_cut(file)) {
    index.timestamps.pop_back();
    index.notes.push_back(concat("the file is cut before its container's end: the first ",
                                 found - 1, " frames are read"));
  } else if (capture.stated_frames > 0 && capture.stated_frames != static_cast<double>(found)) {
    index.notes.push_back(concat("the container states ", capture.stated_frames,
                                 " frames, of which ", found, " can be decoded"));
  }
}

VideoIndex index_video(const fs::path& file) {
  const VideoCapture capture = open_capture(file);
  VideoIndex index;
  while (capture.grab()) {
    index.timestamps.push_back(rounded_stamp(capture.stamp()));
  }
  if (!index.timestamps.empty()) {
    settle_end(file, capture, index);
  }
  require(!index.timestamps.empty(), file.string(), ": holds no frame that can be decoded whole");
  settle_stamps(file, capture, index);
  if (capture.is_shown_turned) {
    index.notes.emplace_back(
        "the file says that players turn its images: they are read as they are stored, and the "
        "camera must be that of such ones");
  }
  return index;
}

/// Decodes the frames of a video for any thread, one at a time.
class VideoFrames {
 public:
  explicit VideoFrames(fs::path file) : file_(std::move(file)) {}

  cv::Mat read(std::size_t index) {
    const std::scoped_lock lock(mutex_);
    if (index < next_) {
      if (index + 1 == next_ && !latest_.empty()) {
        return latest_.clone();
      }
      capture_.reset();
    }
    if (!capture_) {
      capture_ = open_capture(file_);
      next_ = 0;
    }
    latest_.release();
    for (; next_ <= index; ++next_) {
      require(capture_->grab(), file_.string(), ": its frame ", next_,
              " cannot be decoded any more, expected the file as it was when it was opened");
    }
    latest_ = capture_->image();
    require(!latest_.empty(), file_.string(), ": its frame ", index, " cannot be decoded");
    return latest_.clone();
  }

 private:
  fs::path file_;
  std::mutex mutex_;
  std::optional<VideoCapture> capture_;
  std::size_t next_ = 0;  ///< frame that the capture gives next
  cv::Mat latest_;        ///< the frame before it, if that was asked for
};

}  // namespace

SequenceSource open_video(const fs::path& file, const std::optional<RgbdCamera>& camera) {
  require(camera.has_value(), file.string(),
          ": a video says nothing of its camera; name it with --camera PRESET or FILE.toml");
  const auto frames = std::make_shared<VideoFrames>(file);
  VideoIndex index = index_video(file);
  require_size(frames->read(0), camera->pinhole, file);
  SequenceSource source;
  source.camera = *camera;
  source.timestamps = std::move(index.timestamps);
  source.notes = std::move(index.notes);
  source.read = [frames, file, pinhole = camera->pinhole,
                 stamps = source.timestamps](std::size_t at) {
    RgbdFrame frame{stamps.at(at), frames->read(at), {}};
    require_size(frame.image, pinhole, file);
    return frame;
  };
  return source;
}

std::vector<double> video_stamps(const fs::path& file) {
  return index_video(file).timestamps;
}

}  // namespace vo
