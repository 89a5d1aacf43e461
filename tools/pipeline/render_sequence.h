#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "synth/generate.h"
#include "vo/core/progress.h"
#include "vo/io/output.h"

namespace tools {

/// All that determines a synthetic sequence.
struct RenderJob {
  std::filesystem::path scene;
  synth::SequenceRecipe recipe;
};

struct RenderOutcome {
  bool was_there = false;          ///< the folder held the same sequence already
  std::vector<std::string> notes;  ///< what the scene file holds that was left out
};

/// Renders into a folder that appears when it is complete. Its sequence.toml records the inputs: an
/// existing folder with the same inputs is left alone.
RenderOutcome render_sequence(const RenderJob& job, const std::filesystem::path& folder,
                              vo::ExistingOutput existing, const vo::Progress& progress);

}  // namespace tools
