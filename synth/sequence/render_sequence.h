#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "synth/gltf/scene_file.h"
#include "synth/sequence/frame_share.h"
#include "synth/sequence/generate.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"

namespace synth {

/// All that determines a synthetic sequence, and how much of it to render now.
struct RenderJob {
  SceneFile scene;
  SequenceRecipe recipe;
  FrameShare share;
};

/// All of it but the scene, as TOML.
std::string format_recipe(const RenderJob& job);

struct RenderOutcome {
  bool was_there = false;               ///< the folder held the same sequence already
  std::filesystem::path folder;         ///< where the frames are
  std::size_t rendered = 0;             ///< frames
  std::size_t missing = 0;              ///< frames, of the whole sequence; 0 = it is complete
  std::vector<std::string> notes;       ///< what the scene file holds that was left out
  std::size_t depth_beyond_16_bit = 0;  ///< pixels of the frames rendered that became 0
};

/// Renders into a folder that appears when the sequence is complete. Its sequence.toml records the
/// inputs: an existing folder with the same inputs is left alone. Until then the frames lie in
/// `<folder>.part`, which any number of processes with the same inputs fill, at once or one after
/// the other, each with its share; whichever finds all frames there completes the sequence. A frame
/// that is there is not rendered again.
RenderOutcome render_sequence(const RenderJob& job, const std::filesystem::path& folder,
                              vo::ExistingOutput existing, const vo::Progress& progress);

/// The frames of the job's share that are neither in the folder nor waiting beside it, and would be
/// rendered; all of them without a folder.
std::vector<std::size_t> frames_to_render(const RenderJob& job, const Scene& scene,
                                          const std::filesystem::path& folder);

}  // namespace synth
