#include "vo/frames/depth_units.h"

#include <algorithm>
#include <cmath>

#include "vo/core/error.h"
#include "vo/image_files/png.h"

namespace vo {
namespace {

constexpr double kMaxUnits = 65534;

/// The greatest 16-bit depth: a sensor's or a writer's mark for "beyond range", not a distance.
constexpr std::uint16_t kSaturatedDepth = 65535;

}  // namespace

cv::Mat_<std::uint16_t> to_depth_units(const DepthImage& depth, double units_per_m) {
  cv::Mat_<std::uint16_t> units(depth.size());
  std::transform(depth.begin(), depth.end(), units.begin(), [&](float metres) {
    const double value = std::round(metres * units_per_m);
    return value >= 0 && value <= kMaxUnits ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
  });
  return units;
}

DepthImage from_depth_units(const cv::Mat_<std::uint16_t>& units, double units_per_m) {
  DepthImage depth;
  units.convertTo(depth, CV_32F, 1 / units_per_m);
  depth.setTo(0, units == kSaturatedDepth);
  return depth;
}

double farthest_in_16_bit(double units_per_m) {
  return kMaxUnits / units_per_m;
}

std::size_t count_beyond_16_bit(const DepthImage& depth, double units_per_m) {
  return static_cast<std::size_t>(std::count_if(depth.begin(), depth.end(), [&](float metres) {
    return std::round(metres * units_per_m) > kMaxUnits;
  }));
}

DepthImage read_depth_png(const std::filesystem::path& path, const RgbdCameraModel& camera) {
  const cv::Mat image = read_png(path);
  require_size(image, camera.model, path);
  require(image.type() == CV_16UC1, path.string(),
          ": expected depth of 16 bits in one channel, got ",
          image.channels() == 3 ? "colour" : "8 bits");
  return from_depth_units(image, camera.depth_units_per_m);
}

void require_size(const cv::Mat& image, const CameraModel& camera,
                  const std::filesystem::path& path) {
  require(image.cols == camera.width() && image.rows == camera.height(), path.string(), ": is ",
          image.cols, "x", image.rows, " px, expected the camera's ", camera.width(), "x",
          camera.height());
}

}  // namespace vo
