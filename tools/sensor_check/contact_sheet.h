#pragma once

#include <cstddef>

#include <opencv2/core.hpp>

#include "synth/camera/renderers_over_time.h"
#include "synth/camera/sequence_camera.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Returns a picture with a row per sensor preset, of one frame of a motion: image | its centre
/// enlarged | depth, red far, black none | the measured surface, shaded | depth error, red too far,
/// blue too near.
cv::Mat_<cv::Vec3b> draw_contact_sheet(const synth::Scene& scene,
                                       const synth::RenderersOverTime& renderers,
                                       const vo::PinholeCamera& camera,
                                       const synth::CameraTruth& motion, std::size_t frame);

}  // namespace tools
