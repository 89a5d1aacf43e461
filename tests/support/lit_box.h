#pragma once

#include <cmath>

#include <opencv2/core.hpp>

#include "synth/scene/scene.h"
#include "tests/support/quads.h"

namespace support {

/// A box of two tones, x, y and z from -1 to 1 m, that a lamp of this radiance lights; no other
/// light. The lamp is behind a camera that looks along z from the middle.
inline synth::Scene lit_box(float radiance = 10) {
  synth::Scene scene;
  for (const float side : {-1.0F, 1.0F}) {
    const synth::Material wall = synth::diffuse({0.5F + 0.3F * side, 0.6F, 0.5F - 0.3F * side});
    synth::add(scene, synth::quad({-1, -1, side}, {2, 0, 0}, {0, 2, 0}), wall);
    synth::add(scene, synth::quad({-1, side, -1}, {2, 0, 0}, {0, 0, 2}), wall);
    synth::add(scene, synth::quad({side, -1, -1}, {0, 2, 0}, {0, 0, 2}), wall);
  }
  synth::Material lamp = synth::diffuse({0, 0, 0});
  lamp.emission.setConstant(radiance);
  synth::add(scene, synth::quad({-0.3F, -0.5F, -0.8F}, {0.6F, 0, 0}, {0, 0, 0.6F}), lamp);
  return scene;
}

/// Returns the root-mean-square difference over the mean of the second image.
inline double relative_error(const cv::Mat_<cv::Vec3f>& image, const cv::Mat_<cv::Vec3f>& truth) {
  const cv::Scalar mean = cv::mean(truth);
  return cv::norm(image, truth, cv::NORM_L2) / std::sqrt(3.0 * static_cast<double>(truth.total())) /
         ((mean[0] + mean[1] + mean[2]) / 3);
}

}  // namespace support
