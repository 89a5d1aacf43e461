#include "tools/cameras/v4l2_camera.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include "vo/core/error.h"
#include "vo/files/system_failure.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFirstDevice = "/dev/video0";
constexpr std::size_t kMostImages = 30;
constexpr std::chrono::milliseconds kPoll{100};
constexpr std::chrono::seconds kPatience{5};

/// Throws Error unless a device is there and can be opened.
void require_device(const std::string& name, const fs::path& device) {
  std::error_code ignored;
  vo::require(fs::exists(device, ignored), name, ": there is no ", device.string(),
              ", expected a camera of Video4Linux2");
  vo::require(fs::is_character_file(device, ignored), name, ": ", device.string(),
              " is no device, expected a camera of Video4Linux2");
  const int descriptor =
      vo::uninterrupted([&] { return ::open(device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC); });
  if (descriptor < 0) {
    vo::fail_with(device, "cannot be opened", errno);
  }
  ::close(descriptor);
}

/// Takes the images of a capture as they come.
class CaptureThread {
 public:
  CaptureThread(std::string name, vo::VideoCapture capture)
      : name_(std::move(name)), capture_(std::move(capture)) {
    thread_ = std::thread([this] { run(); });
  }
  ~CaptureThread() {
    {
      const std::scoped_lock lock(mutex_);
      is_stopped_ = true;
    }
    thread_.join();
  }
  CaptureThread(const CaptureThread&) = delete;
  CaptureThread& operator=(const CaptureThread&) = delete;
  CaptureThread(CaptureThread&&) = delete;
  CaptureThread& operator=(CaptureThread&&) = delete;

  /// Waits for an image; leaves it for `next`.
  cv::Size wait_for_size() {
    std::unique_lock lock(mutex_);
    if (!has_come_.wait_for(lock, kPatience, [&] { return !images_.empty(); })) {
      fail_to_wait();
    }
    return images_.front().image.size();
  }

  std::optional<vo::RgbdFrame> next(const std::function<bool()>& is_stopped) {
    const auto begin = std::chrono::steady_clock::now();
    while (!is_stopped()) {
      std::unique_lock lock(mutex_);
      if (has_come_.wait_for(lock, kPoll, [&] { return !images_.empty(); })) {
        vo::RgbdFrame frame = std::move(images_.front());
        images_.pop_front();
        return frame;
      }
      if (std::chrono::steady_clock::now() - begin > kPatience) {
        fail_to_wait();
      }
    }
    return std::nullopt;
  }

  std::size_t missed() {
    const std::scoped_lock lock(mutex_);
    return missed_;
  }

 private:
  [[noreturn]] void fail_to_wait() const {
    vo::fail_as(vo::ErrorKind::temporary, name_, ": has given no frame for ", kPatience.count(),
                " s");
  }

  void run() {
    while (!is_told_to_stop()) {
      if (capture_.grab()) {
        add({capture_.stamp(), capture_.image(), {}});
      } else {
        std::this_thread::sleep_for(kPoll);
      }
    }
  }

  bool is_told_to_stop() {
    const std::scoped_lock lock(mutex_);
    return is_stopped_;
  }

  void add(vo::RgbdFrame frame) {
    const std::scoped_lock lock(mutex_);
    const bool is_later = !latest_stamp_ || frame.timestamp > *latest_stamp_;
    if (frame.image.empty() || !is_later || images_.size() == kMostImages) {
      ++missed_;
      return;
    }
    latest_stamp_ = frame.timestamp;
    images_.push_back(std::move(frame));
    has_come_.notify_one();
  }

  std::string name_;
  vo::VideoCapture capture_;  ///< the thread's alone
  std::mutex mutex_;          ///< of all below
  std::condition_variable has_come_;
  std::deque<vo::RgbdFrame> images_;
  std::optional<double> latest_stamp_;
  std::size_t missed_ = 0;
  bool is_stopped_ = false;
  std::thread thread_;
};

/// Returns the size of the images that a user asks for.
cv::Size chosen_size(const std::string& name, const LiveCameraSettings& settings) {
  vo::require(settings.camera.has_value(), name,
              ": says nothing of its lens, expected --camera FILE.toml or a preset");
  const vo::PinholeCamera& pinhole = settings.camera->pinhole;
  const cv::Size size = settings.size ? cv::Size(settings.size->first, settings.size->second)
                                      : cv::Size(pinhole.width, pinhole.height);
  vo::require(size == cv::Size(pinhole.width, pinhole.height), name, ": ", size.width, "x",
              size.height, " px are asked for, the camera that was given has ", pinhole.width, "x",
              pinhole.height);
  return size;
}

}  // namespace

LiveCamera open_v4l2_camera(const std::string& name, const std::string& device,
                            const LiveCameraSettings& settings) {
  const cv::Size size = chosen_size(name, settings);
  const fs::path file = device.empty() ? kFirstDevice : device;
  require_device(name, file);
  std::optional<vo::VideoCapture> capture = vo::video_library(name).open_camera(file, size);
  vo::require(capture.has_value(), name, ": ", file.string(),
              " does not start: it captures no images, or another program uses it");
  return live_camera_of(name, file.string(), std::move(*capture), settings);
}

LiveCamera live_camera_of(const std::string& name, const std::string& device,
                          vo::VideoCapture capture, const LiveCameraSettings& settings) {
  const cv::Size wanted = chosen_size(name, settings);
  const auto images = std::make_shared<CaptureThread>(name, std::move(capture));
  const cv::Size size = images->wait_for_size();
  vo::require(size == wanted, name, ": its images have ", size.width, "x", size.height,
              " px, expected ", wanted.width, "x", wanted.height);
  return {.device = device,
          .camera = *settings.camera,
          .has_depth = false,
          .next = [images](
                      const std::function<bool()>& is_stopped) { return images->next(is_stopped); },
          .missed = [images] { return images->missed(); },
          .notes = {"the camera has no depth: track what it sees with --mode mono"}};
}

}  // namespace tools
