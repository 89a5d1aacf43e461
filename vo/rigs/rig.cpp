#include "vo/rigs/rig.h"

#include <algorithm>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace vo {
namespace {

/// Throws Error, which begins with `place`, unless the images of two cameras are those of one.
void require_equal_images(const std::string& place, PinholeCamera left, PinholeCamera right) {
  const std::vector<Field> ours = fields_of(left);
  const std::vector<Field> theirs = fields_of(right);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const std::string value = ours[i].get();
    const std::string other = theirs[i].get();
    require(value == other, place, "expected equal images of a rectified pair, got ", ours[i].key,
            " = ", value, " and ", other);
  }
  require(left.distortion.is_zero(), place,
          "expected a rectified pair, whose lenses have no distortion");
}

/// Throws Error, which begins with `place`, unless a camera at T_left_right is beside another.
void require_side_by_side(const std::string& place, const SE3& T_left_right) {
  constexpr double kMaxAngle = 1e-7;  // rad
  constexpr double kMaxShare = 1e-6;  // of the baseline
  require(T_left_right.angle() <= kMaxAngle, place,
          "expected a rectified pair, whose axes are parallel, got ", T_left_right.angle(),
          " rad between them");
  const Eigen::Vector3d& position = T_left_right.translation();
  require(
      position.x() > 0, place,
      "expected a partner to the right, at a positive baseline along this camera's x axis, got ",
      format_real(position.x()), " m");
  require(position.tail<2>().norm() <= kMaxShare * position.x(), place,
          "expected a rectified pair, whose baseline is along x, got the partner at ",
          format_real(position.x()), ", ", format_real(position.y()), ", ",
          format_real(position.z()), " m");
}

}  // namespace

bool is_plain_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
}

std::string describe(const RigCamera& camera) {
  return concat(camera.place, ": camera '", camera.name, "'");
}

std::string describe(const RigProjector& projector) {
  return concat(projector.place, ": projector '", projector.name, "'");
}

bool has_infrared_camera(const Rig& rig) {
  return std::any_of(rig.cameras.begin(), rig.cameras.end(),
                     [](const RigCamera& camera) { return camera.spectrum == Spectrum::infrared; });
}

const RigCamera& stereo_partner(const Rig& rig, const RigCamera& left) {
  const std::string pair = concat(describe(left), ": stereo = \"", left.stereo, "\"");
  const std::string place = pair + ": ";
  const auto right =
      std::find_if(rig.cameras.begin(), rig.cameras.end(),
                   [&](const RigCamera& camera) { return camera.name == left.stereo; });
  require(right != rig.cameras.end(), place, "expected the name of another camera of the rig");
  require(right->name != left.name, place, "expected another camera, at a baseline above 0 m");
  require_equal_images(place, left.camera.model.pinhole_for(pair),
                       right->camera.model.pinhole_for(pair));
  require(left.time_offset == right->time_offset, place,
          "expected frames at the same time, got time_offset = ", format_real(left.time_offset),
          " and ", format_real(right->time_offset), " s");
  require_side_by_side(place, left.T_body_camera.inverse() * right->T_body_camera);
  return *right;
}

double stereo_baseline(const Rig& rig, const RigCamera& left) {
  const RigCamera& right = stereo_partner(rig, left);
  return (left.T_body_camera.inverse() * right.T_body_camera).translation().norm();
}

}  // namespace vo
