#include "vo/geometry/camera_model.h"

#include <cmath>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/geometry/field_of_view.h"

namespace vo {
namespace {

PinholeCamera resized_view(const PinholeCamera& camera, int width, int height) {
  const double x_scale = static_cast<double>(width) / camera.width;
  const double y_scale = static_cast<double>(height) / camera.height;
  PinholeCamera result = camera;
  result.width = width;
  result.height = height;
  result.fx = camera.fx * x_scale;
  result.fy = camera.fy * y_scale;
  result.cx = (camera.cx + 0.5) * x_scale - 0.5;
  result.cy = (camera.cy + 0.5) * y_scale - 0.5;
  return result;
}

EquirectangularCamera resized_view(const EquirectangularCamera& /*camera*/, int width,
                                   int /*height*/) {
  const int half = width > 1 ? width / 2 : 1;
  return {.width = 2 * half, .height = half};
}

double width_of_pixel(const PinholeCamera& camera) {
  return 1 / std::sqrt(std::abs(camera.fx * camera.fy));
}

double width_of_pixel(const EquirectangularCamera& camera) {
  return std::numbers::pi / camera.height;
}

}  // namespace

int CameraModel::width() const {
  return std::visit([](const auto& camera) { return camera.width; }, camera_);
}

int CameraModel::height() const {
  return std::visit([](const auto& camera) { return camera.height; }, camera_);
}

double CameraModel::depth(const Eigen::Vector3d& p_camera) const {
  return has_optical_axis() ? p_camera.z() : p_camera.norm();
}

Eigen::Vector2d CameraModel::project(const Eigen::Vector3d& p_camera) const {
  return std::visit([&](const auto& camera) { return camera.project(p_camera); }, camera_);
}

bool CameraModel::sees(const Eigen::Vector3d& p_camera) const {
  const PinholeCamera* const camera = pinhole();
  return camera != nullptr ? is_in_view(*camera, p_camera) : depth(p_camera) > 0;
}

Eigen::Vector2d CameraModel::displacement(const Eigen::Vector2d& from,
                                          const Eigen::Vector2d& to) const {
  Eigen::Vector2d way = to - from;
  if (wraps()) {
    way.x() = std::remainder(way.x(), width());
  }
  return way;
}

double CameraModel::pixel_width() const {
  return std::visit([](const auto& camera) { return width_of_pixel(camera); }, camera_);
}

std::optional<std::array<Eigen::Vector3d, 2>> CameraModel::pixel_sides(
    const Eigen::Vector2d& pixel) const {
  const auto* const panorama = std::get_if<EquirectangularCamera>(&camera_);
  return panorama == nullptr ? std::nullopt : std::optional(panorama->ray_derivatives(pixel));
}

CameraModel CameraModel::resized(int width, int height) const {
  return std::visit(
      [&](const auto& camera) { return CameraModel(resized_view(camera, width, height)); },
      camera_);
}

const PinholeCamera& CameraModel::pinhole_for(std::string_view what) const {
  const PinholeCamera* const camera = pinhole();
  if (camera == nullptr) {
    fail(what, ": expected a pinhole camera, got projection = \"", to_string(projection()), "\"");
  }
  return *camera;
}

void CameraModel::validate() const {
  std::visit([](const auto& camera) { camera.validate(); }, camera_);
}

void RgbdCameraModel::validate() const {
  constexpr double kMinDepthUnits = 1e-3;
  constexpr double kMaxDepthUnits = 1e9;
  model.validate();
  require(depth_units_per_m >= kMinDepthUnits && depth_units_per_m <= kMaxDepthUnits,
          "camera: expected depth_units_per_m from ", kMinDepthUnits, " to ", kMaxDepthUnits,
          ", got ", depth_units_per_m);
  require(std::abs(readout.seconds) <= kMaxReadout, "camera: expected readout from ", -kMaxReadout,
          " to ", kMaxReadout, " s, got ", readout.seconds);
  depth_noise.validate();
}

void RgbdCamera::validate() const {
  RgbdCameraModel(*this).validate();
}

}  // namespace vo
