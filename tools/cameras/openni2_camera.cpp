#include "tools/cameras/openni2_camera.h"

#ifdef EDVO_HAS_OPENNI2

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>

#include <OpenNI.h>
#include <opencv2/imgproc.hpp>

#include "tools/cameras/frame_pairs.h"
#include "vo/core/error.h"
#include "vo/frames/depth_units.h"

namespace tools {
namespace {

constexpr double kMicrosecondsPerSecond = 1e6;
constexpr int kPollMs = 100;
constexpr int kMostPolls = 50;  // without a frame: 5 s

/// Returns what OpenNI2 says of its last failure, in one line.
std::string last_failure() {
  std::string text = openni::OpenNI::getExtendedError();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "no reason is given"
                                    : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

void require_ok(openni::Status status, const std::string& name, const char* what) {
  vo::require(status == openni::STATUS_OK, name, ": ", what, ": ", last_failure());
}

/// OpenNI2 and its drivers, as long as this lives.
class Library {
 public:
  explicit Library(const std::string& name) {
    require_ok(openni::OpenNI::initialize(), name, "OpenNI2 cannot start");
  }
  ~Library() { openni::OpenNI::shutdown(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  Library(Library&&) = delete;
  Library& operator=(Library&&) = delete;
};

bool is_depth_format(openni::PixelFormat format) {
  return format == openni::PIXEL_FORMAT_DEPTH_1_MM || format == openni::PIXEL_FORMAT_DEPTH_100_UM;
}

double units_per_m(openni::PixelFormat format) {
  return format == openni::PIXEL_FORMAT_DEPTH_100_UM ? 10'000 : 1'000;
}

/// The modes in which the two sensors run.
struct Modes {
  openni::VideoMode colour;
  openni::VideoMode depth;

  int pixels() const { return colour.getResolutionX() * colour.getResolutionY(); }
  int rate_hz() const { return std::min(colour.getFps(), depth.getFps()); }

  /// Returns whether these are to be preferred: a video's rate first, then size.
  bool are_better_than(const Modes& other) const {
    constexpr int kVideoHz = 25;
    return std::pair(std::min(rate_hz(), kVideoHz), pixels()) >
           std::pair(std::min(other.rate_hz(), kVideoHz), other.pixels());
  }
};

/// Returns the modes of one size, that of the settings if they have one.
std::optional<Modes> best_modes(const openni::SensorInfo& colour, const openni::SensorInfo& depth,
                                const LiveCameraSettings& settings) {
  std::optional<Modes> best;
  for (int i = 0; i < colour.getSupportedVideoModes().getSize(); ++i) {
    for (int j = 0; j < depth.getSupportedVideoModes().getSize(); ++j) {
      const Modes modes{colour.getSupportedVideoModes()[i], depth.getSupportedVideoModes()[j]};
      const std::pair size(modes.colour.getResolutionX(), modes.colour.getResolutionY());
      const bool fits =
          modes.colour.getPixelFormat() == openni::PIXEL_FORMAT_RGB888 &&
          is_depth_format(modes.depth.getPixelFormat()) &&
          size == std::pair(modes.depth.getResolutionX(), modes.depth.getResolutionY()) &&
          size == settings.size.value_or(size);
      if (fits && (!best || modes.are_better_than(*best))) {
        best = modes;
      }
    }
  }
  return best;
}

/// A device whose two sensors run.
class Openni2Camera {
 public:
  Openni2Camera(std::string name, const std::string& uri, const LiveCameraSettings& settings)
      : name_(std::move(name)), library_(name_), pairs_(settings.max_time_difference) {
    require_ok(device_.open(uri.empty() ? openni::ANY_DEVICE : uri.c_str()), name_,
               "cannot be opened");
    choose_modes(settings);
    register_depth();
    require_ok(depth_.start(), name_, "its depth does not start");
    require_ok(colour_.start(), name_, "its colour does not start");
  }
  ~Openni2Camera() {
    colour_.destroy();
    depth_.destroy();
    device_.close();
  }
  Openni2Camera(const Openni2Camera&) = delete;
  Openni2Camera& operator=(const Openni2Camera&) = delete;
  Openni2Camera(Openni2Camera&&) = delete;
  Openni2Camera& operator=(Openni2Camera&&) = delete;

  std::string device() const {
    const openni::DeviceInfo& info = device_.getDeviceInfo();
    return vo::concat(info.getVendor(), " ", info.getName(), " (", info.getUri(), ")");
  }

  vo::RgbdCamera camera(const LiveCameraSettings& settings) {
    vo::RgbdCamera camera = settings.camera.value_or(vo::RgbdCamera{.pinhole = nominal_pinhole()});
    const openni::VideoMode mode = colour_.getVideoMode();
    vo::require(camera.pinhole.width == mode.getResolutionX() &&
                    camera.pinhole.height == mode.getResolutionY(),
                name_, ": its images have ", mode.getResolutionX(), "x", mode.getResolutionY(),
                " px, the camera that was given ", camera.pinhole.width, "x",
                camera.pinhole.height);
    if (!settings.camera) {
      notes_.emplace_back("the intrinsics are those of the device's nominal field of view");
    }
    camera.depth_units_per_m = units_per_m(depth_.getVideoMode().getPixelFormat());
    camera.validate();
    return camera;
  }

  const std::vector<std::string>& notes() const { return notes_; }
  std::size_t missed() const { return missed_; }

  std::optional<vo::RgbdFrame> next(const std::function<bool()>& is_stopped) {
    for (int polls = 0; polls < kMostPolls; ++polls) {
      if (is_stopped()) {
        return std::nullopt;
      }
      if (!read_one()) {
        continue;
      }
      polls = 0;
      if (std::optional<vo::RgbdFrame> frame = pairs_.take()) {
        return frame;
      }
    }
    vo::fail_as(vo::ErrorKind::temporary, name_, ": has given no frame for ",
                kPollMs * kMostPolls / 1000, " s");
  }

 private:
  void choose_modes(const LiveCameraSettings& settings) {
    const openni::SensorInfo* colour = device_.getSensorInfo(openni::SENSOR_COLOR);
    const openni::SensorInfo* depth = device_.getSensorInfo(openni::SENSOR_DEPTH);
    vo::require(colour != nullptr && depth != nullptr, name_, ": has no ",
                colour == nullptr ? "colour" : "depth", ", expected colour and depth");
    const std::optional<Modes> modes = best_modes(*colour, *depth, settings);
    vo::require(modes.has_value(), name_, ": has no colour (RGB) and depth (1 mm or 0.1 mm) of ",
                settings.size ? vo::concat(settings.size->first, "x", settings.size->second, " px")
                              : "one size");
    require_ok(colour_.create(device_, openni::SENSOR_COLOR), name_, "has no stream of colour");
    require_ok(depth_.create(device_, openni::SENSOR_DEPTH), name_, "has no stream of depth");
    require_ok(colour_.setVideoMode(modes->colour), name_, "refuses a mode of colour");
    require_ok(depth_.setVideoMode(modes->depth), name_, "refuses a mode of depth");
    colour_.setMirroringEnabled(false);
    depth_.setMirroringEnabled(false);
  }

  void register_depth() {
    constexpr auto kToColour = openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR;
    if (!device_.isImageRegistrationModeSupported(kToColour) ||
        device_.setImageRegistrationMode(kToColour) != openni::STATUS_OK) {
      notes_.emplace_back(
          "the device does not register its depth to its colour, which costs a few px");
    }
    device_.setDepthColorSyncEnabled(true);  // a device that cannot is paired by stamps alone
  }

  vo::PinholeCamera nominal_pinhole() {
    const openni::VideoMode mode = colour_.getVideoMode();
    const int width = mode.getResolutionX();
    const int height = mode.getResolutionY();
    const double fov_x = colour_.getHorizontalFieldOfView();  // rad
    const double fov_y = colour_.getVerticalFieldOfView();
    vo::require(fov_x > 0 && fov_y > 0, name_,
                ": does not say its field of view, expected --camera FILE.toml");
    return {.width = width,
            .height = height,
            .fx = width / 2.0 / std::tan(fov_x / 2),
            .fy = height / 2.0 / std::tan(fov_y / 2),
            .cx = (width - 1) / 2.0,
            .cy = (height - 1) / 2.0};
  }

  /// Reads an image of either sensor; false if none arrives in time.
  bool read_one() {
    std::array<openni::VideoStream*, 2> streams = {&colour_, &depth_};
    int ready = -1;
    const openni::Status status =
        openni::OpenNI::waitForAnyStream(streams.data(), int{streams.size()}, &ready, kPollMs);
    if (status == openni::STATUS_TIME_OUT) {
      return false;
    }
    require_ok(status, name_, "gives no more frames");
    openni::VideoFrameRef frame;
    require_ok(streams.at(static_cast<std::size_t>(ready))->readFrame(&frame), name_,
               "a frame cannot be read");
    add(frame);
    return true;
  }

  void add(const openni::VideoFrameRef& frame) {
    const double timestamp = static_cast<double>(frame.getTimestamp()) / kMicrosecondsPerSecond;
    const auto stride = static_cast<std::size_t>(frame.getStrideInBytes());
    // OpenCV's constructor takes pixels that may be written; these are copied.
    void* pixels = const_cast<void*>(frame.getData());
    if (frame.getSensorType() == openni::SENSOR_COLOR) {
      vo::ColorImage image;
      cv::cvtColor(cv::Mat(frame.getHeight(), frame.getWidth(), CV_8UC3, pixels, stride), image,
                   cv::COLOR_RGB2BGR);
      missed_ += last_index_ ? std::max(frame.getFrameIndex() - *last_index_ - 1, 0) : 0;
      last_index_ = frame.getFrameIndex();
      pairs_.add_colour(timestamp, image);
    } else {
      const cv::Mat_<std::uint16_t> units(frame.getHeight(), frame.getWidth(),
                                          static_cast<std::uint16_t*>(pixels), stride);
      pairs_.add_depth(timestamp, vo::from_depth_units(
                                      units, units_per_m(frame.getVideoMode().getPixelFormat())));
    }
  }

  std::string name_;
  Library library_;
  openni::Device device_;
  openni::VideoStream colour_;
  openni::VideoStream depth_;
  FramePairs pairs_;
  std::optional<int> last_index_;  ///< of the device's colour frames
  std::size_t missed_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace

LiveCamera open_openni2_camera(const std::string& name, const std::string& uri,
                               const LiveCameraSettings& settings) {
  const auto device = std::make_shared<Openni2Camera>(name, uri, settings);
  LiveCamera camera{.device = device->device(), .camera = device->camera(settings)};
  camera.next = [device](const std::function<bool()>& is_stopped) {
    return device->next(is_stopped);
  };
  camera.missed = [device] { return device->missed(); };
  camera.notes = device->notes();
  return camera;
}

}  // namespace tools

#endif
