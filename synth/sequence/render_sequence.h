#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synth/gltf/scene_file.h"
#include "synth/sequence/frame_share.h"
#include "synth/sequence/generate.h"
#include "vo/core/progress.h"
#include "vo/files/output.h"

namespace synth {

/// Everything that determines a synthetic sequence, and the share of it to render now.
struct RenderJob {
  SceneFile scene;
  SequenceRecipe recipe;
  FrameShare share;
};

/// Returns the job's recipe, which excludes the scene's files and the share, as TOML.
std::string format_recipe(const RenderJob& job);

/// Returns the actors of a scene as TOML, their files without their folders.
std::string format_actors(const std::vector<ActorOptions>& actors);

/// Returns sequence.toml, the file that says what a sequence was made of: conventions that a reader
/// must know, and the inputs that identify it.
vo::NamedBytes sequence_manifest(const RenderJob& job);

/// Returns the maker of the job's frames, which refers to the job. `renderers` are as those of
/// FrameGenerator.
std::unique_ptr<const FrameGenerator> frame_generator(
    const RenderJob& job, std::shared_ptr<const RenderersOverTime> renderers = nullptr);

/// Returns the files that belong to no single frame but for sequence.toml: those of the recipe, and
/// truth/labels.json beside channels of ids.
std::vector<vo::NamedBytes> sequence_files(const RenderJob& job);

struct RenderOutcome {
  bool was_there = false;                ///< whether the folder held this sequence already
  std::filesystem::path folder;          ///< folder that holds the frames
  std::size_t rendered = 0;              ///< number of frames rendered by this call
  std::size_t missing = 0;               ///< number of frames the sequence lacks; 0 = complete
  std::vector<std::string> notes;        ///< on what is left out of the scene, and on classes
  std::size_t depth_beyond_16_bit = 0;   ///< rendered depth pixels stored as 0
  std::optional<double> depth_coverage;  ///< of all frames in `folder`; none if none can be read
  std::string warning;                   ///< about little coverage; empty where it is enough
};

/// Returns notes on what the pictures of a job leave out of its scene's file and materials.
std::vector<std::string> notes_on_scene(const RenderJob& job);

/// Renders a job's share into a folder that appears when the sequence is complete. Its
/// sequence.toml records the inputs: an existing folder with equal inputs is left alone. Until
/// completion the frames lie in `<folder>.part`, which any number of processes with equal inputs
/// fill, at once or in turn, each with its share; each frame is rendered by one of them, and one
/// completes the sequence when all are there. A finished frame is not rendered again unless its
/// files have changed since. `observe` is called with the frames that this call renders.
RenderOutcome render_sequence(const RenderJob& job, const std::filesystem::path& folder,
                              const vo::OutputPolicy& policy, const vo::Progress& progress,
                              const MadeFrameObserver& observe = {});

}  // namespace synth
