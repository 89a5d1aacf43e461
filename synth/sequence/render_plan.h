#pragma once

#include <cstddef>
#include <filesystem>

#include "synth/sequence/render_sequence.h"
#include "synth/sequence/share_renderer.h"

namespace synth {

/// The cost of a render job, estimated from a few of its frames.
struct RenderPlan {
  std::size_t frames = 0;    ///< number of frames in the job's share
  std::size_t there = 0;     ///< number of frames in the share that are finished already
  std::size_t files = 0;     ///< number of files still to write
  double bytes = 0;          ///< number of bytes still to write
  double processor_s = 0;    ///< s, processor time of all threads together
  std::size_t measured = 0;  ///< number of frames rendered for the estimate
};

/// Estimates a job's cost from up to three of its missing frames, which it renders without writing.
/// With an empty `folder` all frames of the share are missing.
RenderPlan plan_sequence(const RenderJob& job, const std::filesystem::path& folder);

/// Estimates the cost of a share likewise, a frame for each part, without that of loading a scene.
/// Its parts are of so many kinds, in turn, as those of a rig are by its cameras, whose frames cost
/// unlike much: each kind is measured equally often, once at least.
RenderPlan plan_share(const ShareJob& job, const std::filesystem::path& folder,
                      std::size_t kinds = 1);

/// Loads a scene and returns the processor time, s, of that.
double load_scene(const SceneFile& scene);

}  // namespace synth
