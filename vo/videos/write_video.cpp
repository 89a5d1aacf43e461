#include "vo/videos/write_video.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "vo/core/error.h"
#include "vo/files/streamed_output.h"
#include "vo/videos/video_library.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

/// The ends of names, and the codec of each.
constexpr std::array kCodecs = {std::pair{".avi", VideoCodec::ffv1},
                                std::pair{".mp4", VideoCodec::mpeg4}};

std::optional<VideoCodec> codec_of(const fs::path& path) {
  for (const auto& [extension, codec] : kCodecs) {
    if (path.extension() == extension) {
      return codec;
    }
  }
  return std::nullopt;
}

VideoFormat format_of(const fs::path& path, const SequenceSource& source, const cv::Mat& image) {
  require(image.cols % 2 == 0 && image.rows % 2 == 0, path.string(),
          ": a video has images of even width and height, got ", image.cols, "x", image.rows,
          " px");
  return {.codec = *codec_of(path),
          .rate_hz = video_rate(source.timestamps),
          .size = image.size(),
          .channels = image.channels()};
}

void require_alike(const fs::path& path, const VideoFormat& format, const cv::Mat& image,
                   std::size_t index) {
  require(image.size() == format.size && image.channels() == format.channels, path.string(),
          ": frame ", index, " is of ", image.cols, "x", image.rows, " px in ", image.channels(),
          " channels, expected the first one's ", format.size.width, "x", format.size.height,
          " in ", format.channels);
}

}  // namespace

double video_rate(const std::vector<double>& timestamps) {
  constexpr double kOfOne = 30;
  constexpr double kSteps = 1000;  // of a Hz
  if (timestamps.size() < 2) {
    return kOfOne;
  }
  const double mean =
      static_cast<double>(timestamps.size() - 1) / (timestamps.back() - timestamps.front());
  return std::round(mean * kSteps) / kSteps;
}

bool video_holds(const std::vector<double>& timestamps) {
  constexpr double kMostDifference = 0.5e-3;  // s
  const double rate_hz = video_rate(timestamps);
  for (std::size_t i = 0; i < timestamps.size(); ++i) {
    if (std::abs(timestamps[i] - static_cast<double>(i) / rate_hz) > kMostDifference) {
      return false;
    }
  }
  return true;
}

void require_video_name(const fs::path& path) {
  if (!codec_of(path)) {
    fail_as(ErrorKind::usage, path.string(),
            ": expected a name with .avi (FFV1, which keeps every pixel) or .mp4 (MPEG-4) for a "
            "video");
  }
}

void write_video(const fs::path& path, const SequenceSource& source, const OutputPolicy& policy,
                 const Progress& progress) {
  require_video_name(path);
  const VideoLibrary& library = video_library(path.string());
  StreamedOutput output(path, policy, path.extension());  // by which FFmpeg chooses a container
  const fs::path partial = output.open_by_name();
  cv::Mat image = source.read(0).image;
  const VideoFormat format = format_of(path, source, image);
  const std::optional<VideoEncoder> encoder = library.make_file(partial, format);
  require(encoder.has_value(), path.string(), ": OpenCV's FFmpeg cannot encode ", format.size.width,
          "x", format.size.height, " px at ", format.rate_hz, " Hz in it");
  const std::size_t frames = source.timestamps.size();
  for (std::size_t i = 0; i < frames; ++i) {
    if (i > 0) {
      image = source.read(i).image;
    }
    require_alike(path, format, image, i);
    encoder->write(image);
    progress(i + 1, frames);
  }
  encoder->finish();
  if (library.count_images(partial) != frames) {
    fail_as(ErrorKind::temporary, path.string(),
            ": cannot be written: fewer images are in the file than were encoded, as on a full "
            "disk");
  }
  output.commit();
}

}  // namespace vo
