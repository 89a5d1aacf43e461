#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "tests/support/quads.h"

namespace synth {

/// A ball of flat triangles about (0, 0, 2) m, of radius 0.5 m, whose front is its outside.
inline Mesh flat_ball() {
  constexpr int kRows = 24;
  Mesh ball;
  for (int v = 0; v <= kRows; ++v) {
    for (int u = 0; u <= 2 * kRows; ++u) {
      const double colatitude = std::numbers::pi * v / kRows;
      const double longitude = std::numbers::pi * u / kRows;
      const Eigen::Vector3d out(std::sin(colatitude) * std::cos(longitude), std::cos(colatitude),
                                std::sin(colatitude) * std::sin(longitude));
      ball.positions.push_back((0.5 * out + Eigen::Vector3d(0, 0, 2)).cast<float>());
    }
  }
  for (int v = 0; v < kRows; ++v) {
    for (int u = 0; u < 2 * kRows; ++u) {
      const int a = v * (2 * kRows + 1) + u;
      const int b = a + 2 * kRows + 1;
      ball.triangles.insert(ball.triangles.end(), {{a, a + 1, b}, {a + 1, b + 1, b}});
    }
  }
  return ball;
}

/// Gives a scene an environment of radiance 1 on all sides.
inline void surround_with_white(Scene& scene) {
  scene.environment.radiance.create(16, 32);
  scene.environment.radiance = cv::Vec3f(1, 1, 1);
}

/// A ball of this material in an environment of radiance 1 on all sides.
inline Scene ball_in_white(const Material& material) {
  Scene scene;
  add(scene, flat_ball(), material);
  surround_with_white(scene);
  return scene;
}

}  // namespace synth
