#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <utility>

#include "synth/denoising/other_frames.h"
#include "synth/rendering/capture.h"
#include "synth/rendering/renderer.h"

namespace synth {

/// The frames of a sequence, each told by its index alone. All is called from any thread.
struct FrameSource {
  std::size_t count = 0;
  std::function<Capture(std::size_t index)> capture;
  std::function<std::shared_ptr<const Renderer>(std::size_t index)> renderer;
};

/// A frame without most of its noise, and the renderer of the scene during it.
struct DenoisedFrame {
  RenderedFrame rendered;
  std::shared_ptr<const Renderer> renderer;
};

/// Renders the frames of a sequence, from any thread and in any order, each with the light of the
/// frames up to `reach` before and after it. A number of noisy frames, of a moving scene with its
/// geometry, are kept for the next; what was not kept is rendered again, so that a frame depends on
/// its index alone.
class DenoisedFrames {
 public:
  DenoisedFrames(FrameSource source, int reach, std::size_t kept);
  DenoisedFrames(FrameSource source, int reach)
      : DenoisedFrames(std::move(source), reach, frames_at_once(reach)) {}
  ~DenoisedFrames();
  DenoisedFrames(const DenoisedFrames&) = delete;
  DenoisedFrames& operator=(const DenoisedFrames&) = delete;
  DenoisedFrames(DenoisedFrames&&) = delete;
  DenoisedFrames& operator=(DenoisedFrames&&) = delete;

  DenoisedFrame render(std::size_t index) const;

 private:
  struct Kept;

  /// Returns how many frames the threads of this program need at once if they go in order.
  static std::size_t frames_at_once(int reach);
  static OtherFrame seen_from(const Kept& here, const Kept& other);
  std::shared_ptr<const Kept> noisy(std::size_t index) const;
  std::shared_ptr<Kept> kept(std::size_t index) const;

  FrameSource source_;
  std::size_t reach_;
  std::size_t capacity_;  ///< frames that are kept at most, 1 or more
  mutable std::mutex mutex_;
  mutable std::list<std::shared_ptr<Kept>> kept_;  ///< the one that was needed last comes first
};

}  // namespace synth
