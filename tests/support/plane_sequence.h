#pragma once

#include <filesystem>

#include "tests/support/textured_plane.h"
#include "vo/dataset/sequence.h"

namespace support {

/// Writes a sequence of the textured plane, 160x120, the camera moving 5 mm to the right per frame.
inline vo::Trajectory write_plane_sequence(const std::filesystem::path& folder, int frames) {
  const vo::RgbdCamera camera{vo::PinholeCamera::from_horizontal_fov(160, 120, 60)};
  const vo::SequenceLayout layout{.camera = camera};
  vo::Trajectory truth;
  for (int i = 0; i < frames; ++i) {
    const vo::SE3 T_world_camera(Eigen::Quaterniond::Identity(), {0.005 * i, 0, 0});
    truth.push_back({i / 30.0, T_world_camera});
    const vo::RgbdFrame frame = TexturedPlane().render(camera.pinhole, T_world_camera, i / 30.0);
    vo::write_files(folder, vo::encode_frame(layout, static_cast<std::size_t>(i), frame));
  }
  vo::write_files(folder, vo::encode_lists(layout, truth));
  return truth;
}

}  // namespace support
