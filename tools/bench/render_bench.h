#pragma once

#include <string>
#include <vector>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Cost of rendering one frame with one setting.
struct RenderCost {
  std::string renderer;
  std::string mode;
  int samples = 0;
  int width = 0;   ///< px
  int height = 0;  ///< px
  std::size_t triangles = 0;
  double cpu_s = 0;   ///< processor time of all threads, mean over the poses, s
  double wall_s = 0;  ///< wall-clock time, mean over the poses, s; depends on the machine's load
};

struct RenderBench {
  std::vector<RenderCost> costs;   ///< costs of each renderer and mode
  std::vector<RenderCost> growth;  ///< costs over samples, resolution and triangles
  std::string absent;              ///< why the rasterizer could not run; empty if it could
};

/// Returns four views in different directions from the centre of the scene's bounding box.
vo::Trajectory views_from_the_middle(const synth::Scene& scene);

/// Returns the scene with each triangle split in four, which leaves its appearance unchanged.
synth::Scene subdivided(const synth::Scene& scene);

RenderBench bench_rendering(const synth::Scene& scene, const vo::PinholeCamera& camera,
                            const vo::Trajectory& views);

std::string format_table(const RenderBench& bench);
std::string format_json(const RenderBench& bench);

}  // namespace tools
