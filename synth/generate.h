#pragma once

#include <filesystem>

#include "synth/renderer.h"
#include "synth/scene.h"
#include "synth/sensor.h"
#include "vo/core/camera.h"
#include "vo/core/progress.h"
#include "vo/core/trajectory.h"
#include "vo/io/sequence.h"

namespace synth {

/// All but the scene that determines a synthetic sequence.
struct SequenceRecipe {
  vo::Trajectory truth;  ///< T_world_camera of each frame
  vo::RgbdCamera camera;
  RenderOptions render;
  SensorOptions sensor;
  vo::FloatDepth float_depth = vo::FloatDepth::none;
};

/// Renders, measures and writes one sequence into an existing folder, frames in parallel on all
/// cores; groundtruth.txt is `recipe.truth`. Each frame is a pure function of the scene, the recipe
/// and its index.
void generate_sequence(const Scene& scene, const SequenceRecipe& recipe,
                       const std::filesystem::path& folder, const vo::Progress& progress);

}  // namespace synth
