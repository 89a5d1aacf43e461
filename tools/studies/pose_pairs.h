#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "synth/scene/scene.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Random views of a scene and, for each, the same view moved so far that the image moves by a
/// given mean flow.
struct PosePairOptions {
  std::vector<double> flows_px{4, 12, 27, 42};  ///< mean over the pixels with depth
  int views = 24;
  std::uint64_t seed = 1;
  double min_depth = 0.6;        ///< m, of every pixel of a view
  double min_mean_depth = 1.5;   ///< m, of a view
  int min_textured_blocks = 10;  ///< of the 12 that a view is divided into

  std::size_t poses_per_view() const { return 1 + flows_px.size(); }
  void validate() const;  ///< throws vo::Error
};

/// T_world_camera of each view followed by those of its moved views, a second apart. Translation
/// and rotation have random directions; each causes about half of the flow. Throws vo::Error when
/// the scene has too few views that are textured and in which every pixel has depth.
vo::Trajectory pose_pairs(const synth::Scene& scene, const vo::PinholeCamera& camera,
                          const PosePairOptions& options);

}  // namespace tools
