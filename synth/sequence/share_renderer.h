#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "synth/sequence/generate.h"
#include "synth/sequence/render_sequence.h"
#include "vo/core/progress.h"
#include "vo/output_folders/staged_folder.h"

namespace synth {

/// Returns a frame as a part of the folder of its sequence.
vo::FolderPart frame_part(const SequenceRecipe& recipe, std::size_t frame);

/// Returns what the folder of a sequence will hold: a part for each frame, in order, and `marker`.
vo::StagedContent sequence_content(const SequenceRecipe& recipe, vo::NamedBytes marker);

/// Returns what the folder of a job's sequence will hold: its labels, too, and its manifest.
vo::StagedContent sequence_content(const RenderJob& job);

/// Makes the frame that is a part of a folder, from any thread, its files named as the part has
/// them.
using PartMaker = std::function<MadeFrame(std::size_t part)>;

/// The parts of a folder that are rendered now. `content` must outlive it.
struct ShareJob {
  const vo::StagedContent& content;
  std::vector<std::size_t> parts;      ///< indices of the content's parts
  std::function<PartMaker()> prepare;  ///< called once, and only where there is a part to render
};

/// Returns the share of a sequence, of which `content` is `sequence_content`; the job must outlive
/// it, too.
ShareJob share_job(const RenderJob& job, const vo::StagedContent& content);

/// A ShareRenderer tells this observer of its work; an empty callback is not called.
struct RenderObservers {
  vo::Progress progress;    ///< also called while others are waited for
  MadeFrameObserver frame;  ///< its index is the part's
};

/// Renders parts into a staged folder that other processes may be filling, too. What it is given
/// must outlive it.
class ShareRenderer {
 public:
  ShareRenderer(const ShareJob& job, const vo::StagedFolder& staged, RenderObservers observers)
      : job_(job), staged_(staged), observers_(std::move(observers)) {}

  /// Returns the number of the content's parts that are not there.
  std::size_t missing() const;

  /// Returns when all of these parts are there: those that nobody else renders are rendered here,
  /// in parallel, the others are waited for.
  void render(std::vector<std::size_t> parts);

  std::size_t rendered() const { return rendered_; }  ///< number of parts rendered here

  /// Number of depth pixels that 16 bits could not hold, of the frames rendered here.
  std::size_t depth_beyond_16_bit() const { return depth_beyond_16_bit_; }

 private:
  void keep_missing(std::vector<std::size_t>& parts) const;
  void render_unless_others_do(std::size_t index);
  void tell() const;

  const ShareJob& job_;
  const vo::StagedFolder& staged_;
  RenderObservers observers_;
  PartMaker make_;  ///< empty until there is a part to render
  std::size_t total_ = 0;
  std::size_t done_ = 0;  ///< number of parts that are there, of `total_`
  std::atomic<std::size_t> rendered_ = 0;
  std::atomic<std::size_t> depth_beyond_16_bit_ = 0;
  std::mutex mutex_;
};

/// Renders a share into a folder that appears when all parts of its content are there, as
/// `render_sequence` says; the outcome is without what is said of the scene and of depth's
/// coverage.
RenderOutcome render_share(const ShareJob& job, const std::filesystem::path& folder,
                           const vo::OutputPolicy& policy, const RenderObservers& observers);

/// Returns the parts of a share that the folder or else its staging folder lacks; all of them if
/// neither has the job's marker or the folder's name is empty.
std::vector<std::size_t> parts_to_render(const ShareJob& job, const std::filesystem::path& folder);

}  // namespace synth
