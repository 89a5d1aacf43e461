#pragma once

#include <string>
#include <vector>

#include "synth/rendering/renderer.h"
#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// What one frame costs in one setting.
struct RenderCost {
  std::string renderer;
  std::string mode;
  int samples = 0;
  int width = 0;   ///< px
  int height = 0;  ///< px
  std::size_t triangles = 0;
  double cpu_s = 0;   ///< of all threads, mean over the poses
  double wall_s = 0;  ///< likewise, by the clock on the wall: what else runs counts, too
};

struct RenderBench {
  std::vector<RenderCost> costs;   ///< of the settings that are promised
  std::vector<RenderCost> growth;  ///< with samples, resolution and triangles
  std::string absent;              ///< why the rasterizer is not among them
};

/// From the middle of the scene's box, in four directions.
vo::Trajectory views_from_the_middle(const synth::Scene& scene);

/// Each triangle in four, which changes nothing that is seen.
synth::Scene subdivided(const synth::Scene& scene);

RenderBench bench_rendering(const synth::Scene& scene, const vo::PinholeCamera& camera,
                            const vo::Trajectory& views);

std::string format_table(const RenderBench& bench);
std::string format_json(const RenderBench& bench);

}  // namespace tools
