#pragma once

#include <filesystem>
#include <string>

#include "synth/path_planning/path_options.h"
#include "synth/rendering/renderer.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Returns a picture with a row per sensor preset, of the middle frame of a path through a glTF
/// scene, as WebP: image | its centre enlarged | depth, red far, black none | the measured surface,
/// shaded | depth error, red too far, blue too near.
std::string contact_sheet(const std::filesystem::path& scene, const synth::RenderOptions& render,
                          const vo::PinholeCamera& camera, const synth::PathOptions& path);

}  // namespace tools
