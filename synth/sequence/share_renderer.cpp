#include "synth/sequence/share_renderer.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include <tbb/parallel_for.h>

#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/output_folders/part_records.h"

namespace synth {
namespace {

namespace fs = std::filesystem;

/// Returns the error's message, for a stopped run with advice on where its finished frames are.
std::string with_advice(const vo::Error& error, const fs::path& staging) {
  const bool is_stopped =
      error.kind() == vo::ErrorKind::temporary || error.kind() == vo::ErrorKind::interrupted;
  return is_stopped ? vo::concat(error.what(), "; finished frames are kept in ", staging.string(),
                                 ", the same command continues there")
                    : error.what();
}

/// Renders the job's parts and completes the folder if no part is missing then. Parts whose files
/// are not as they were recorded are rendered again, whoever made them.
void render_and_finish(const ShareJob& job, ShareRenderer& renderer, vo::StagedFolder& staged,
                       RenderOutcome& outcome) {
  for (std::vector<std::size_t> parts = job.parts; !parts.empty();) {
    renderer.render(parts);
    outcome.rendered = renderer.rendered();
    outcome.depth_beyond_16_bit = renderer.depth_beyond_16_bit();
    outcome.missing = renderer.missing();
    parts = outcome.missing == 0 ? staged.finish() : std::vector<std::size_t>();
  }
}

bool holds(const fs::path& folder, const vo::NamedBytes& marker) {
  const fs::path file = folder / marker.name;
  return fs::is_regular_file(file) && vo::read_file(file) == marker.bytes;
}

}  // namespace

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

vo::StagedContent sequence_content(const RenderJob& job) {
  vo::StagedContent content = sequence_content(job.recipe, sequence_manifest(job));
  content.rest = sequence_files(job);
  return content;
}

std::size_t ShareRenderer::missing() const {
  const std::vector<vo::FolderPart>& parts = job_.content.parts;
  return static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(),
                    [this](const vo::FolderPart& part) { return !staged_.has(part); }));
}

void ShareRenderer::keep_missing(std::vector<std::size_t>& parts) const {
  std::erase_if(parts, [this](std::size_t part) { return staged_.has(job_.content.parts[part]); });
}

void ShareRenderer::render(std::vector<std::size_t> parts) {
  keep_missing(parts);
  total_ = parts.size();
  done_ = 0;
  while (!parts.empty()) {
    if (!make_) {
      make_ = job_.prepare();
    }
    // Whoever is free takes the next part, so that what frames share with their neighbours lasts.
    std::atomic<std::size_t> next = 0;
    tbb::parallel_for(std::size_t{0}, parts.size(),
                      [&](std::size_t) { render_unless_others_do(parts[next++]); });
    keep_missing(parts);
    if (!parts.empty()) {
      vo::pause_for_others([this] { tell(); });
    }
  }
}

void ShareRenderer::render_unless_others_do(std::size_t index) {
  const vo::FolderPart& part = job_.content.parts[index];
  if (std::optional<vo::PartialFile> claim = staged_.claim(part)) {
    const MadeFrame made = make_(index);
    staged_.put(std::move(*claim), made.files);
    depth_beyond_16_bit_ += made.depth_beyond_16_bit;
    ++rendered_;
    if (observers_.frame) {
      const std::lock_guard lock(mutex_);
      observers_.frame(index, made);
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

RenderOutcome render_share(const ShareJob& job, const fs::path& folder,
                           const vo::OutputPolicy& policy, const RenderObservers& observers) {
  const vo::Progress& progress = observers.progress;
  RenderOutcome outcome{.folder = folder};
  const vo::WaitObserver waiting = [&] {
    if (progress) {
      progress(0, 0);
    }
  };
  vo::StagedFolder staged(folder, job.content, policy, waiting);
  if (staged.is_finished()) {
    outcome.was_there = true;
    return outcome;
  }
  try {
    ShareRenderer renderer(job, staged, observers);
    render_and_finish(job, renderer, staged, outcome);
  } catch (const vo::Error& error) {
    throw vo::Error(with_advice(error, staged.staging()), error.kind());
  }
  if (outcome.missing > 0) {
    outcome.folder = staged.staging();
  }
  return outcome;
}

std::vector<std::size_t> parts_to_render(const ShareJob& job, const fs::path& folder) {
  std::vector<std::size_t> missing = job.parts;
  if (folder.empty()) {
    return missing;
  }
  for (const fs::path& place : {folder, vo::StagedFolder::staging_of(folder)}) {
    if (holds(place, job.content.marker)) {
      const vo::PartRecords records(place);
      std::erase_if(missing, [&](std::size_t index) {
        const vo::FolderPart& part = job.content.parts[index];
        return records.has(part.name, part.files);
      });
      return missing;
    }
  }
  return missing;
}

}  // namespace synth
