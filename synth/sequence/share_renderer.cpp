#include "synth/sequence/share_renderer.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>

namespace synth {

vo::FolderPart frame_part(const SequenceRecipe& recipe, std::size_t frame) {
  constexpr std::size_t kDigits = 6;
  std::string number = std::to_string(frame);
  number.insert(0, kDigits - std::min(kDigits, number.size()), '0');
  return {number + ".txt", frame_files(recipe, frame)};
}

vo::StagedContent sequence_content(const SequenceRecipe& recipe, vo::NamedBytes marker) {
  vo::StagedContent content{std::move(marker), {}, sequence_files(recipe)};
  for (std::size_t frame = 0; frame < recipe.truth.size(); ++frame) {
    content.parts.push_back(frame_part(recipe, frame));
  }
  return content;
}

std::vector<std::size_t> ShareRenderer::missing(const std::vector<std::size_t>& frames) const {
  std::vector<std::size_t> missing;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(missing),
               [&](std::size_t frame) { return !staged_.has(content_.parts[frame]); });
  return missing;
}

void ShareRenderer::render(std::vector<std::size_t> frames) {
  frames = missing(frames);
  total_ = frames.size();
  done_ = 0;
  while (!frames.empty()) {
    if (!generator_) {
      generator_ = std::make_unique<const FrameGenerator>(subject_.scene, subject_.recipe);
    }
    tbb::parallel_for(std::size_t{0}, frames.size(),
                      [&](std::size_t i) { render_unless_others_do(frames[i]); });
    frames = missing(frames);
    if (!frames.empty()) {
      vo::pause_for_others([this] { tell(); });
    }
  }
}

void ShareRenderer::render_unless_others_do(std::size_t frame) {
  const vo::FolderPart& part = content_.parts[frame];
  if (std::optional<vo::PartialFile> claim = staged_.claim(part)) {
    const MadeFrame made = generator_->make(frame);
    staged_.put(std::move(*claim), made.files);
    depth_beyond_16_bit_ += made.depth_beyond_16_bit;
    ++rendered_;
    if (observers_.frame) {
      const std::lock_guard lock(mutex_);
      observers_.frame(frame, made);
    }
  } else if (!staged_.has(part)) {
    return;
  }
  const std::lock_guard lock(mutex_);
  ++done_;
  tell();
}

void ShareRenderer::tell() const {
  if (observers_.progress) {
    observers_.progress(done_, total_);
  }
}

}  // namespace synth
