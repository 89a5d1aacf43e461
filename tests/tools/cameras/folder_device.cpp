// A driver of OpenNI2: a camera without hardware that gives the frames of the sequence in the
// folder $EDVO_DEVICE_FOLDER, over and over, with stamps of its own: 30 Hz from 1 s. There is no
// device without the variable. After $EDVO_DEVICE_SIGINT frames its process gets SIGINT, as by
// Ctrl-C.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <vector>

// The driver's interface names these two of a header that Debian does not have.
#define XN_NEW(Type, argument) new Type(argument)  // NOLINT
#define XN_DELETE(pointer) delete (pointer)        // NOLINT
#include <Driver/OniDriverAPI.h>
#include <opencv2/imgproc.hpp>

#include "vo/dataset/sequence.h"
#include "vo/frames/depth_units.h"

namespace {

constexpr int kRateHz = 30;
constexpr std::uint64_t kFirstStampUs = 1'000'000;
constexpr std::uint64_t kPeriodUs = 33'333;
constexpr double kUnitsPerM = 1000;

const char* variable(const char* name) {
  return std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets variables
}

/// The images of one sensor as the device gives them: RGB of 8 bit, or depth in mm.
struct Sensor {
  OniSensorType type;
  OniVideoMode mode;
  float fov_x_rad;
  float fov_y_rad;
  std::vector<cv::Mat> images;
};

class FolderStream : public oni::driver::StreamBase {
 public:
  explicit FolderStream(Sensor& sensor) : sensor_(sensor) {}

  bool runs() const { return runs_; }

  OniStatus start() override {
    runs_ = true;
    return ONI_STATUS_OK;
  }

  void stop() override { runs_ = false; }

  OniStatus getProperty(int id, void* data, int* size) override {
    switch (id) {
      case ONI_STREAM_PROPERTY_VIDEO_MODE:
        return answer(sensor_.mode, data, size);
      case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
        return answer(sensor_.fov_x_rad, data, size);
      case ONI_STREAM_PROPERTY_VERTICAL_FOV:
        return answer(sensor_.fov_y_rad, data, size);
      default:
        return ONI_STATUS_NOT_SUPPORTED;
    }
  }

  OniStatus setProperty(int id, const void* /*data*/, int /*size*/) override {
    return id == ONI_STREAM_PROPERTY_VIDEO_MODE ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
  }

  OniBool isPropertySupported(int id) override {
    return id == ONI_STREAM_PROPERTY_VIDEO_MODE || id == ONI_STREAM_PROPERTY_HORIZONTAL_FOV ||
                   id == ONI_STREAM_PROPERTY_VERTICAL_FOV
               ? TRUE
               : FALSE;
  }

  void give(int index) {
    OniFrame* frame = getServices().acquireFrame();
    if (frame == nullptr) {
      return;
    }
    const cv::Mat& image = sensor_.images[static_cast<std::size_t>(index) % sensor_.images.size()];
    frame->dataSize = static_cast<int>(image.total() * image.elemSize());
    std::memcpy(frame->data, image.data, image.total() * image.elemSize());
    frame->sensorType = sensor_.type;
    frame->frameIndex = index;
    frame->timestamp = kFirstStampUs + static_cast<std::uint64_t>(index) * kPeriodUs;
    frame->width = image.cols;
    frame->height = image.rows;
    frame->videoMode = sensor_.mode;
    frame->croppingEnabled = FALSE;
    frame->stride = static_cast<int>(image.step);
    raiseNewFrame(frame);
    getServices().releaseFrame(frame);
  }

 private:
  template <typename Value>
  static OniStatus answer(const Value& value, void* data, int* size) {
    std::memcpy(data, &value, sizeof value);
    *size = sizeof value;
    return ONI_STATUS_OK;
  }

  Sensor& sensor_;
  std::atomic<bool> runs_ = false;
};

class FolderDevice : public oni::driver::DeviceBase {
 public:
  explicit FolderDevice(const std::string& folder) {
    const vo::SequenceReader sequence(folder);
    const vo::PinholeCamera& pinhole = sequence.camera().pinhole;
    for (Sensor& sensor : sensors_) {
      sensor.mode.resolutionX = pinhole.width;
      sensor.mode.resolutionY = pinhole.height;
      sensor.fov_x_rad = static_cast<float>(2 * std::atan(pinhole.width / 2.0 / pinhole.fx));
      sensor.fov_y_rad = static_cast<float>(2 * std::atan(pinhole.height / 2.0 / pinhole.fy));
    }
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      const vo::RgbdFrame frame = sequence.read(i);
      cv::Mat rgb;
      cv::cvtColor(frame.image, rgb, cv::COLOR_BGR2RGB);
      sensors_[0].images.push_back(rgb);
      sensors_[1].images.push_back(vo::to_depth_units(frame.depth, kUnitsPerM));
    }
    for (std::size_t i = 0; i < infos_.size(); ++i) {
      infos_.at(i) = {sensors_.at(i).type, 1, &sensors_.at(i).mode};
    }
    thread_ = std::thread([this] { give_frames(); });
  }
  ~FolderDevice() override {
    has_ended_ = true;
    thread_.join();
  }
  FolderDevice(const FolderDevice&) = delete;
  FolderDevice& operator=(const FolderDevice&) = delete;
  FolderDevice(FolderDevice&&) = delete;
  FolderDevice& operator=(FolderDevice&&) = delete;

  OniStatus getSensorInfoList(OniSensorInfo** infos, int* count) override {
    *infos = infos_.data();
    *count = static_cast<int>(infos_.size());
    return ONI_STATUS_OK;
  }

  oni::driver::StreamBase* createStream(OniSensorType type) override {
    const std::size_t i = type == ONI_SENSOR_COLOR ? 0 : 1;
    streams_.at(i) = std::make_unique<FolderStream>(sensors_.at(i));
    return streams_.at(i).get();
  }

  void destroyStream(oni::driver::StreamBase* stream) override {
    has_ended_ = true;
    if (thread_.joinable()) {
      thread_.join();
    }
    thread_ = std::thread([] {});
    for (auto& own : streams_) {
      if (own.get() == stream) {
        own.reset();
      }
    }
  }

 private:
  void give_frames() {
    const char* end = variable("EDVO_DEVICE_SIGINT");
    const int last = end != nullptr ? std::atoi(end) : -1;  // NOLINT(cert-err34-c)
    int index = 0;
    while (!has_ended_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (!streams_[0] || !streams_[1] || !streams_[0]->runs() || !streams_[1]->runs()) {
        continue;
      }
      streams_[1]->give(index);
      streams_[0]->give(index);
      ++index;
      if (index == last) {
        ::kill(::getpid(), SIGINT);
      }
    }
  }

  std::array<Sensor, 2> sensors_ = {
      {{ONI_SENSOR_COLOR, {ONI_PIXEL_FORMAT_RGB888, 0, 0, kRateHz}, 0, 0, {}},
       {ONI_SENSOR_DEPTH, {ONI_PIXEL_FORMAT_DEPTH_1_MM, 0, 0, kRateHz}, 0, 0, {}}}};
  std::array<OniSensorInfo, 2> infos_{};
  std::array<std::unique_ptr<FolderStream>, 2> streams_;
  std::atomic<bool> has_ended_ = false;
  std::thread thread_;
};

class FolderDriver : public oni::driver::DriverBase {
 public:
  explicit FolderDriver(OniDriverServices* services) : DriverBase(services) {}

  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback changed, void* cookie) override {
    DriverBase::initialize(connected, disconnected, changed, cookie);
    if (variable("EDVO_DEVICE_FOLDER") != nullptr) {
      std::strcpy(info_.uri, "folder");     // NOLINT(clang-analyzer-security.insecureAPI.strcpy)
      std::strcpy(info_.vendor, "edvo");    // NOLINT(clang-analyzer-security.insecureAPI.strcpy)
      std::strcpy(info_.name, "Sequence");  // NOLINT(clang-analyzer-security.insecureAPI.strcpy)
      deviceConnected(&info_);
    }
    return ONI_STATUS_OK;
  }

  oni::driver::DeviceBase* deviceOpen(const char* /*uri*/, const char* /*mode*/) override {
    try {
      return new FolderDevice(variable("EDVO_DEVICE_FOLDER"));
    } catch (const std::exception&) {
      return nullptr;
    }
  }

  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }

  void shutdown() override {}

 private:
  OniDeviceInfo info_{};
};

}  // namespace

// NOLINTNEXTLINE: the interface's own names and pointers
ONI_EXPORT_DRIVER(FolderDriver)
