#pragma once

#include <filesystem>
#include <string>

#include "synth/path_planning/path_options.h"
#include "synth/rendering/renderer.h"
#include "vo/core/progress.h"
#include "vo/geometry/camera.h"

namespace tools {

/// Throws vo::Error for images whose centre cannot be enlarged, or whose sheet would have more
/// pixels a side than WebP holds.
void require_sheet_size(int width, int height);

/// Returns a picture with a row per sensor preset, of the middle frame of a path through a glTF
/// scene, as WebP: image | its centre enlarged | depth, red far, black none | the measured surface,
/// shaded | depth error, red too far, blue too near. The rows are the steps of the progress.
/// Requires `require_sheet_size`.
std::string contact_sheet(const std::filesystem::path& scene, const synth::RenderOptions& render,
                          const vo::PinholeCamera& camera, const synth::PathOptions& path,
                          const vo::Progress& progress);

}  // namespace tools
