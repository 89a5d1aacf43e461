#pragma once

#include <numbers>

#include "tests/support/textured_plane.h"
#include "vo/core/hash.h"

namespace support {

/// A hand-held sway of a few centimetres and degrees, 40 frames long: up to 2 cm and 0.5 deg a
/// frame. The first pose is the identity.
inline vo::SE3 sway(int frame) {
  const double phase = 2 * std::numbers::pi * frame / 40;
  vo::Vector6d xi;
  xi << 0.08 * std::sin(phase), 0.05 * (1 - std::cos(phase)), 0.04 * std::sin(2 * phase),
      0.02 * std::sin(phase), 0.03 * std::sin(phase + 1) - 0.03 * std::sin(1), 0.02 * phase;
  return vo::SE3::exp(xi);
}

/// The plane at 30 Hz from a pose.
inline vo::RgbdFrame plane_frame(const vo::PinholeCamera& camera, const vo::SE3& T_world_camera,
                                 int index) {
  return TexturedPlane().render(camera, T_world_camera, index / 30.0);
}

/// The plane at 30 Hz from the sway.
inline vo::RgbdFrame sway_frame(const vo::PinholeCamera& camera, int index) {
  return plane_frame(camera, sway(index), index);
}

/// A frame that shows one grey at 2 m everywhere: a wall without texture, a covered lens (0), a
/// blinded sensor (255).
inline vo::RgbdFrame blank_frame(const vo::PinholeCamera& camera, int grey, int index) {
  return {index / 30.0, vo::ByteImage(camera.height, camera.width, static_cast<uchar>(grey)),
          vo::DepthImage(camera.height, camera.width, 2.0F)};
}

/// Of zero mean and unit variance, the sum of four uniform values: bell-shaped, at most 3.5.
inline double hash_noise(std::uint64_t value) {
  double sum = -2;
  for (std::uint64_t i = 0; i < 4; ++i) {
    sum += vo::mixed_uniform(4 * value + i);
  }
  return sum * std::numbers::sqrt3;
}

/// The frame with noise of a standard deviation in grey levels, fresh for each seed.
inline vo::RgbdFrame with_noise(vo::RgbdFrame frame, double sigma, std::uint64_t seed) {
  vo::ByteImage noisy = frame.image.clone();
  const auto pixels = static_cast<std::uint64_t>(noisy.total());
  for (int i = 0; i < static_cast<int>(pixels); ++i) {
    uchar& grey = noisy(i / noisy.cols, i % noisy.cols);
    grey = cv::saturate_cast<uchar>(
        grey + sigma * hash_noise(seed * pixels + static_cast<std::uint64_t>(i)));
  }
  frame.image = noisy;
  return frame;
}

}  // namespace support
