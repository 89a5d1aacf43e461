#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "synth/scene/scene.h"
#include "synth/sequence/render_sequence.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"

namespace tools {

/// Options for random views of a scene, each with moved views that displace the image by given mean
/// flows.
struct PosePairOptions {
  std::vector<double> flows_px{4, 12, 27, 42};  ///< mean optical flow of each moved view
  int views = 24;
  std::uint64_t seed = 1;
  double min_depth = 0.6;        ///< least depth of any pixel of a view, m
  double min_mean_depth = 1.5;   ///< least mean depth of a view, m
  int min_textured_blocks = 10;  ///< least number of the view's 12 blocks that have texture

  std::size_t poses_per_view() const { return 1 + flows_px.size(); }
  void validate() const;  ///< throws vo::Error on an invalid option
};

/// Returns T_world_camera of each view followed by those of its moved views, 1 s apart. Translation
/// and rotation have random directions; each causes about half of the flow. Throws vo::Error when
/// no textured view in which every pixel has depth is found.
vo::Trajectory pose_pairs(const synth::Scene& scene, const vo::PinholeCamera& camera,
                          const PosePairOptions& options);

/// Returns the job that renders the pose pairs of a glTF scene for `study_pairs`.
synth::RenderJob pose_pairs_job(const std::filesystem::path& scene);

}  // namespace tools
