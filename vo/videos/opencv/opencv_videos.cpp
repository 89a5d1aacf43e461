#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

#include "vo/core/version.h"
#include "vo/videos/video_library.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr double kMillisecondsPerSecond = 1000;

/// Returns a number that a capture states; 0 for what is none.
double stated(const cv::VideoCapture& capture, int property) {
  const double value = capture.get(property);
  return std::isfinite(value) && value > 0 ? value : 0;
}

/// Returns whether images are grey of 8 bits before OpenCV makes colour of them.
bool is_grey(const cv::VideoCapture& capture) {
  const int format = static_cast<int>(capture.get(cv::CAP_PROP_CODEC_PIXEL_FORMAT));
  return format == cv::VideoWriter::fourcc('Y', '8', '0', '0') ||
         format == cv::VideoWriter::fourcc('G', 'R', 'E', 'Y');
}

cv::Mat retrieve(cv::VideoCapture& capture) {
  cv::Mat image;
  if (!capture.retrieve(image) || image.depth() != CV_8U) {
    return {};
  }
  if (image.channels() == 3 && is_grey(capture)) {
    cv::Mat grey;
    cv::extractChannel(image, grey, 0);
    return grey;
  }
  return image.channels() == 3 || image.channels() == 1 ? image.clone() : cv::Mat();
}

VideoCapture capture_of(const std::shared_ptr<cv::VideoCapture>& capture) {
  return {
      .grab = [capture] { return capture->grab(); },
      .image = [capture] { return retrieve(*capture); },
      .stamp = [capture] { return capture->get(cv::CAP_PROP_POS_MSEC) / kMillisecondsPerSecond; },
      .rate_hz = stated(*capture, cv::CAP_PROP_FPS),
      .stated_frames = stated(*capture, cv::CAP_PROP_FRAME_COUNT)};
}

std::optional<VideoCapture> open_file(const fs::path& file) {
  const auto opened = std::make_shared<cv::VideoCapture>(file.string(), cv::CAP_FFMPEG);
  if (!opened->isOpened()) {
    return std::nullopt;
  }
  // Versions of OpenCV differ in which way they turn images.
  opened->set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
  VideoCapture capture = capture_of(opened);
  capture.is_shown_turned = stated(*opened, cv::CAP_PROP_ORIENTATION_META) > 0;
  return capture;
}

std::optional<VideoCapture> open_camera(const fs::path& device,
                                        const std::optional<cv::Size>& size) {
  const auto opened = std::make_shared<cv::VideoCapture>(device.string(), cv::CAP_V4L2);
  if (!opened->isOpened()) {
    return std::nullopt;
  }
  if (size) {
    opened->set(cv::CAP_PROP_FRAME_WIDTH, size->width);
    opened->set(cv::CAP_PROP_FRAME_HEIGHT, size->height);
  }
  return capture_of(opened);
}

int code_of(VideoCodec codec) {
  return codec == VideoCodec::ffv1 ? cv::VideoWriter::fourcc('F', 'F', 'V', '1')
                                   : cv::VideoWriter::fourcc('m', 'p', '4', 'v');
}

std::optional<VideoEncoder> make_file(const fs::path& file, const VideoFormat& format) {
  const auto writer =
      std::make_shared<cv::VideoWriter>(file.string(), cv::CAP_FFMPEG, code_of(format.codec),
                                        format.rate_hz, format.size, format.channels == 3);
  if (!writer->isOpened()) {
    return std::nullopt;
  }
  return VideoEncoder{.write = [writer](const cv::Mat& image) { writer->write(image); },
                      .finish = [writer] { writer->release(); }};
}

std::size_t count_images(const fs::path& file) {
  cv::VideoCapture capture(file.string(), cv::CAP_FFMPEG);
  capture.set(cv::CAP_PROP_FORMAT, -1);  // as they are encoded
  std::size_t count = 0;
  while (capture.grab()) {
    ++count;
  }
  return count;
}

constexpr VideoLibrary kLibrary = {open_file, open_camera, make_file, count_images};

}  // namespace
}  // namespace vo

/// Returns what this library does, or nothing to a program of another version. OpenCV's messages
/// are silenced, because libraries print nothing.
extern "C" __attribute__((visibility("default"))) const vo::VideoLibrary* edvo_video_library(
    const char* version) {
  if (std::strcmp(version, vo::version()) != 0) {
    return nullptr;
  }
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  return &vo::kLibrary;
}
