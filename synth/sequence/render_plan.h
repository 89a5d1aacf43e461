#pragma once

#include <cstddef>
#include <filesystem>

#include "synth/sequence/render_sequence.h"

namespace synth {

/// What a job will take. Of a few frames that are measured, and the same for all others.
struct RenderPlan {
  std::size_t frames = 0;    ///< of the job's share
  std::size_t there = 0;     ///< of these, finished already
  std::size_t files = 0;     ///< to write
  double bytes = 0;          ///< to write
  double processor_s = 0;    ///< of all threads together
  std::size_t measured = 0;  ///< frames
};

/// Renders up to three of the missing frames and writes nothing. `folder` may be empty: then
/// nothing is there.
RenderPlan plan_sequence(const RenderJob& job, const std::filesystem::path& folder);

}  // namespace synth
