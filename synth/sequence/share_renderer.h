#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "synth/sequence/generate.h"
#include "vo/core/progress.h"
#include "vo/output_folders/staged_folder.h"

namespace synth {

/// Returns a frame as a part of the folder of its sequence.
vo::FolderPart frame_part(const SequenceRecipe& recipe, std::size_t frame);

/// Returns what the folder of a sequence will hold: a part for each frame, in order, and `marker`.
vo::StagedContent sequence_content(const SequenceRecipe& recipe, vo::NamedBytes marker);

/// A SequenceSubject is the scene and the recipe that the frames of a sequence are made of.
struct SequenceSubject {
  const Scene& scene;
  const SequenceRecipe& recipe;
};

/// A ShareRenderer tells this observer of its work; an empty callback is not called.
struct RenderObservers {
  vo::Progress progress;  ///< also called while others are waited for
  MadeFrameObserver frame;
};

/// Renders frames into a staged folder that other processes may be filling, too. What it is given
/// must outlive it.
class ShareRenderer {
 public:
  /// `content` is `sequence_content`, with which the folder was staged.
  ShareRenderer(const SequenceSubject& subject, const vo::StagedContent& content,
                const vo::StagedFolder& staged, RenderObservers observers)
      : subject_(subject), content_(content), staged_(staged), observers_(std::move(observers)) {}

  /// Returns those of `frames` that are not there.
  std::vector<std::size_t> missing(const std::vector<std::size_t>& frames) const;

  /// Returns when all frames are there: those that nobody else renders are rendered here, in
  /// parallel, the others are waited for.
  void render(std::vector<std::size_t> frames);

  std::size_t rendered() const { return rendered_; }  ///< number of frames rendered here

  /// Number of depth pixels that 16 bits could not hold, of the frames rendered here.
  std::size_t depth_beyond_16_bit() const { return depth_beyond_16_bit_; }

 private:
  void render_unless_others_do(std::size_t frame);
  void tell() const;

  SequenceSubject subject_;
  const vo::StagedContent& content_;
  const vo::StagedFolder& staged_;
  RenderObservers observers_;
  std::unique_ptr<const FrameGenerator> generator_;  ///< null until there is a frame to render
  std::size_t total_ = 0;
  std::size_t done_ = 0;  ///< number of frames that are there, of `total_`
  std::atomic<std::size_t> rendered_ = 0;
  std::atomic<std::size_t> depth_beyond_16_bit_ = 0;
  std::mutex mutex_;
};

}  // namespace synth
