#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <Eigen/Core>

#include "vo/geometry/camera.h"
#include "vo/geometry/depth_noise.h"
#include "vo/geometry/equirectangular.h"
#include "vo/geometry/readout.h"

namespace vo {

/// How an image shows directions: through a pinhole and its lens, or all of them at once.
enum class CameraProjection { pinhole, equirectangular };

constexpr auto enum_names(CameraProjection) {
  return std::array{std::pair{CameraProjection::pinhole, "pinhole"},
                    std::pair{CameraProjection::equirectangular, "equirectangular"}};
}

/// A camera of any projection: which pixel images which direction, and what its depth is. Depth is
/// counted along the optical axis where there is one; an equirectangular camera has none, and its
/// depth is the distance along the ray. Frame: x right, y down, z forward. What odometry tracks is
/// a PinholeCamera.
class CameraModel {
 public:
  CameraModel() = default;  ///< a pinhole without a size, which `validate` refuses

  // NOLINTNEXTLINE(google-explicit-constructor): a pinhole camera is a camera.
  CameraModel(const PinholeCamera& camera) : camera_(camera) {}
  // NOLINTNEXTLINE(google-explicit-constructor): so is an equirectangular one.
  CameraModel(const EquirectangularCamera& camera) : camera_(camera) {}

  CameraProjection projection() const {
    return static_cast<CameraProjection>(camera_.index());  // the order of the variant's types
  }
  int width() const;   ///< px
  int height() const;  ///< px

  /// Returns whether depth is counted along the z axis; else it is the distance along the ray.
  bool has_optical_axis() const { return projection() == CameraProjection::pinhole; }

  /// Returns whether the image's last column is beside its first.
  bool wraps() const { return projection() == CameraProjection::equirectangular; }

  /// Returns the ray of a pixel, camera axes, its multiples by a depth being the points there:
  /// component 1 along the optical axis, or of length 1 without one. Not a number where the lens
  /// images nothing.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const {
    const PinholeCamera* const camera = pinhole();  // what most pixels are of
    return camera != nullptr ? camera->unproject(pixel, 1)
                             : std::get<EquirectangularCamera>(camera_).unproject(pixel, 1);
  }

  double depth(const Eigen::Vector3d& p_camera) const;  ///< m, above 0 where `project` has a pixel
  Eigen::Vector2d project(const Eigen::Vector3d& p_camera) const;  ///< px, needs a depth above 0

  /// Returns whether the image shows a point that nothing hides, as `is_in_view` says of a pinhole.
  bool sees(const Eigen::Vector3d& p_camera) const;

  /// Returns the way from one pixel to another, px, across the border where that is shorter.
  Eigen::Vector2d displacement(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  /// Returns the width, m at a depth of 1 m, of what one pixel sees: of a pinhole's, on its axis;
  /// of an equirectangular one's, its height, which all rows have and no pixel is wider than.
  double pixel_width() const;

  /// Returns the sides of what a pixel sees, m at a depth of 1 m, camera axes: of an
  /// equirectangular camera, whose pixels are narrower above and below; none for a pinhole's, which
  /// count as round.
  std::optional<std::array<Eigen::Vector3d, 2>> pixel_sides(const Eigen::Vector2d& pixel) const;

  /// Returns a camera with this view and an image of another size; of an equirectangular camera the
  /// height is half the width.
  CameraModel resized(int width, int height) const;

  /// Returns the pinhole, null for a camera of another projection.
  const PinholeCamera* pinhole() const { return std::get_if<PinholeCamera>(&camera_); }

  /// Returns the pinhole; throws Error, which begins with what needs it, for another projection.
  const PinholeCamera& pinhole_for(std::string_view what) const;

  /// Calls `visit` with the camera, a PinholeCamera or an EquirectangularCamera.
  template <typename Visit>
  void apply(const Visit& visit) {
    std::visit(visit, camera_);
  }

  void validate() const;  ///< throws Error unless the values are usable

 private:
  std::variant<PinholeCamera, EquirectangularCamera> camera_;
};

/// A colour camera of any projection with a depth image registered to it; RgbdCamera is one with a
/// pinhole.
struct RgbdCameraModel {
  CameraModel model;
  double depth_units_per_m = 5000;  ///< as those of RgbdCamera
  Readout readout;
  DepthNoise depth_noise;

  RgbdCameraModel() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): an RGB-D camera with a pinhole is one.
  RgbdCameraModel(const RgbdCamera& camera)
      : model(camera.pinhole),
        depth_units_per_m(camera.depth_units_per_m),
        readout(camera.readout),
        depth_noise(camera.depth_noise) {}

  void validate() const;  ///< throws Error unless the values are usable
};

/// Visits the camera's fields but its projection, which says what the fields are.
template <typename Visitor>
void visit_fields(Visitor& visit, RgbdCameraModel& camera) {
  camera.model.apply([&](auto& model) { visit_fields(visit, model); });
  visit_depth_fields(visit, camera);
}

}  // namespace vo
