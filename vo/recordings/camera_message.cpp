#include "vo/recordings/camera_message.h"

#include <algorithm>

#include "vo/core/error.h"

namespace vo {
namespace {

constexpr double kMillimetres = 1000;  // per m

double coefficient(const RosCameraInfo& info, std::size_t index) {
  return index < info.D.size() ? info.D[index] : 0;
}

bool has_beyond(const RosCameraInfo& info, std::size_t first) {
  return info.D.size() > first &&
         std::any_of(info.D.begin() + static_cast<std::ptrdiff_t>(first), info.D.end(),
                     [](double value) { return value != 0; });
}

Distortion distortion_of(const RosCameraInfo& info, const std::string& place) {
  constexpr std::size_t kRational = 8;
  constexpr std::size_t kKannalaBrandt = 4;
  const std::string& model = info.distortion_model;
  const auto d = [&](std::size_t index) { return coefficient(info, index); };
  if (model == "equidistant" || model == "fisheye" || model == "kannala_brandt") {
    require(!has_beyond(info, kKannalaBrandt), place, ": has ", info.D.size(),
            " coefficients of a fisheye, expected 4");
    return {
        .k1 = d(0), .k2 = d(1), .k3 = d(2), .k4 = d(3), .model = DistortionModel::kannala_brandt};
  }
  if (!has_beyond(info, 0)) {
    return {};
  }
  require(model == "plumb_bob" || model == "rational_polynomial", place, ": has a lens of model '",
          model,
          "', expected plumb_bob, rational_polynomial or equidistant; --camera names another");
  require(!has_beyond(info, kRational), place,
          ": has a lens with more than eight coefficients, expected k1, k2, p1, p2, k3, k4, k5, k6 "
          "alone; --camera names another");
  return {.k1 = d(0),
          .k2 = d(1),
          .p1 = d(2),
          .p2 = d(3),
          .k3 = d(4),
          .k4 = d(5),
          .k5 = d(6),
          .k6 = d(7)};
}

}  // namespace

RgbdCamera camera_of(const RosCameraInfo& info, Rectification rectification,
                     const std::string& place) {
  constexpr std::uint32_t kMaxSize = 16384;  // px
  require(info.width <= kMaxSize && info.height <= kMaxSize, place,
          ": expected an image of at most ", kMaxSize, " px in width and height, got ", info.width,
          "x", info.height);
  RgbdCamera camera{.depth_units_per_m = kMillimetres};
  PinholeCamera& pinhole = camera.pinhole;
  pinhole.width = static_cast<int>(info.width);
  pinhole.height = static_cast<int>(info.height);
  const bool is_rectified = rectification == Rectification::rectified && info.P[0] != 0;
  pinhole.fx = is_rectified ? info.P[0] : info.K[0];
  pinhole.fy = is_rectified ? info.P[5] : info.K[4];
  pinhole.cx = is_rectified ? info.P[2] : info.K[2];
  pinhole.cy = is_rectified ? info.P[6] : info.K[5];
  require(pinhole.fx != 0, place,
          ": is of a camera that is not calibrated (its focal length is 0); "
          "name it with --camera PRESET or FILE.toml");
  if (rectification == Rectification::none) {
    pinhole.distortion = distortion_of(info, place);
  }
  try {
    camera.validate();
  } catch (const Error& error) {
    fail(place, ": ", error.what());
  }
  return camera;
}

RosCameraInfo camera_info_of(const PinholeCamera& camera) {
  RosCameraInfo info;
  info.width = static_cast<std::uint32_t>(camera.width);
  info.height = static_cast<std::uint32_t>(camera.height);
  const Distortion& lens = camera.distortion;
  if (lens.model == DistortionModel::kannala_brandt) {
    info.distortion_model = "equidistant";
    info.D = {lens.k1, lens.k2, lens.k3, lens.k4};
  } else if (lens.is_rational()) {
    info.distortion_model = "rational_polynomial";
    info.D = {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3, lens.k4, lens.k5, lens.k6};
  } else {
    info.distortion_model = "plumb_bob";
    info.D = {lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
  }
  info.K = {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {camera.fx, 0, camera.cx, 0, 0, camera.fy, camera.cy, 0, 0, 0, 1, 0};
  return info;
}

}  // namespace vo
