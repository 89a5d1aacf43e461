#include "tools/datasets/plan.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "synth/camera/make_renderer.h"
#include "synth/environment/environment.h"
#include "tools/datasets/layout.h"
#include "tools/datasets/part_folder.h"
#include "tools/datasets/plan_file.h"
#include "tools/datasets/sequence_jobs.h"
#include "tools/sequence_cache/generator_hash.h"
#include "tools/sequence_cache/scene_files_hash.h"
#include "vo/core/error.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/files/partial_file.h"
#include "vo/files/result_files.h"
#include "vo/files/unlocked_file.h"
#include "vo/hashing/content_hash.h"

namespace tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxSequenceFrames = 4000;  // files of one kind in one folder
constexpr std::size_t kMaxParts = 1'000'000;

using Identity = std::map<std::string, std::string>;

/// Throws Error if the folder that a plan is to be written into holds files of somebody else.
void require_own_folder(const fs::path& plan_file) {
  const fs::path folder = plan_file.parent_path();
  if (!path_exists(folder)) {
    return;
  }
  const std::vector<vo::FolderEntry> entries = vo::entries_of(folder);
  const bool is_empty =
      std::all_of(entries.begin(), entries.end(),
                  [](const vo::FolderEntry& entry) { return vo::is_partial_name(entry.name); });
  vo::require(is_empty || path_exists(plan_file), folder.string(),
              ": is no unfinished data set (it has no ", plan_file.filename().string(),
              "), expected one or nothing; rename it, or write to another name");
}

/// Adds the hash of a file that a path is read from, if it is.
void add_path_file(const DatasetSequence& sequence, const fs::path& file, Identity& identity) {
  if (!file.empty()) {
    identity.emplace(vo::concat("paths.", sequence.path, " file ", file.filename().string()),
                     vo::content_hash(vo::read_file(file)));
  }
}

/// Adds the hashes of the files of a sequence's scene, its actors and its environment.
void add_scene_files(const DatasetSequence& sequence, std::map<fs::path, std::string>& hashes,
                     Identity& identity) {
  const auto add = [&](const std::string& name, const fs::path& file) {
    std::string& hash = hashes[file];
    hash = hash.empty() ? scene_files_hash(file) : hash;
    identity.emplace(vo::concat("scenes.", sequence.scene, name), hash);
  };
  add(" files", sequence.scenario.scene_file());
  for (const synth::ActorOptions& actor : sequence.scenario.actors) {
    add(" actor " + actor.file.filename().string(), actor.file);
  }
  const std::string environment = sequence.scenario.resolved_parts().environment;
  if (synth::is_environment_file(environment)) {
    identity.emplace(vo::concat("scenes.", sequence.scene, " environment"),
                     vo::content_hash(vo::read_file(environment)));
  }
}

/// Adds the hashes of the rig's file and of the patterns that it names.
void add_rig_files(const DatasetSpec& spec, Identity& identity) {
  if (!spec.rig) {
    return;
  }
  identity.emplace("rig file", vo::content_hash(vo::read_file(spec.rig_file())));
  for (const vo::RigProjector& projector : spec.rig->projectors) {
    if (projector.has_file()) {
      identity.emplace(vo::concat("rig pattern of projector ", projector.name),
                       vo::content_hash(vo::read_file(projector.file())));
    }
  }
}

/// Returns what determines a data set: all that the spec says, the files that it names, and the
/// program that renders.
Identity identity_of(const DatasetSpec& spec) {
  Identity identity;
  for (const vo::TomlValue& value : spec.values) {
    identity.emplace(value.key, value.text);
  }
  add_rig_files(spec, identity);
  std::map<fs::path, std::string> hashes;
  for (const DatasetSequence& sequence : spec.sequences) {
    add_scene_files(sequence, hashes, identity);
    const synth::PathOptions path = sequence.scenario.resolved_path();
    add_path_file(sequence, path.file, identity);
    add_path_file(sequence, path.file_times, identity);
  }
  std::string names;
  for (const DatasetSequence& sequence : spec.sequences) {
    names += sequence.name + "\n";
  }
  identity.emplace("names of sequences", vo::content_hash(names));
  identity.emplace("program that renders", generator_hash());
  return identity;
}

/// Returns what the filter has against the path of a camera; empty where it passes.
std::string objection(const DatasetFilter& filter, const synth::RenderJob& job) {
  if (filter.is_empty()) {
    return {};
  }
  const synth::PathReport report =
      synth::check_path(job.scene.scene(), job.recipe.camera.model, timed_path(job), filter.limits);
  if (!report.violations.empty()) {
    return report.violations.front();
  }
  double flow = 0;  // px, mean over the frames that have a next one
  for (std::size_t i = 0; i + 1 < report.frames.size(); ++i) {
    flow += report.frames[i].flow_px / static_cast<double>(report.frames.size() - 1);
  }
  if (flow < filter.min_mean_flow_px) {
    return vo::concat("min_mean_flow_px: got ", flow, ", limit ", filter.min_mean_flow_px);
  }
  if (filter.max_mean_flow_px > 0 && flow > filter.max_mean_flow_px) {
    return vo::concat("max_mean_flow_px: got ", flow, ", limit ", filter.max_mean_flow_px);
  }
  return {};
}

/// Returns what the filter has against a sequence, of the first camera that does not pass.
std::string objection(const DatasetFilter& filter, const SequenceJob& job) {
  for (std::size_t camera = 0; camera < job.cameras.size(); ++camera) {
    const std::string reason = objection(filter, job.cameras[camera]);
    if (!reason.empty()) {
      return job.rig ? vo::concat("camera '", job.camera_name(camera), "': ", reason) : reason;
    }
  }
  return {};
}

/// Returns what of a sequence its renderer cannot draw; empty where it draws all. Reads the scene
/// only for a renderer that does not draw every one.
std::string undrawable(const SequenceJob& job) {
  const synth::RenderJob& first = job.cameras.front();  // a rig's others have been looked at
  const synth::SequenceRecipe& recipe = first.recipe;
  if (recipe.render.kind == synth::RendererKind::ray_tracer) {
    return {};
  }
  const synth::Scene& scene = first.scene.scene();
  try {
    synth::require_drawable(recipe.camera.model, recipe.sensor.shutter, recipe.render);
    synth::require_drawable(scene, recipe.render);
  } catch (const vo::Error& error) {
    return error.what();
  }
  return {};
}

/// Plans one sequence: its number of frames, or why there are none.
void plan_one(const DatasetSpec& spec, std::size_t index, SequenceJobs& jobs, DatasetPlan& plan) {
  const DatasetSequence& sequence = spec.sequences[index];
  std::string reason;
  std::string not_drawn;
  try {
    const SequenceJob& job = jobs.job(index);
    not_drawn = undrawable(job);
    reason = objection(spec.filter, job);
    plan.frames[index] = reason.empty() ? job.frame_count() : 0;
  } catch (const vo::Error& error) {
    if (error.kind() != vo::ErrorKind::input) {
      throw;
    }
    reason = error.what();
  }
  vo::require(not_drawn.empty(), spec.file.string(), ": ", sequence.name, ": ", not_drawn);
  if (!reason.empty()) {
    plan.rejected.push_back({sequence.name, reason});
  }
  vo::require(plan.frames[index] <= kMaxSequenceFrames, spec.file.string(), ": ", sequence.name,
              ": ", plan.frames[index], " frames, expected at most ", kMaxSequenceFrames,
              " in one sequence; shorter paths with more seeds have as many");
}

/// Cuts the sequences into parts of nearly equal length. With further formats, which are converted
/// from whole sequences, a sequence is one part.
void add_parts(const DatasetSpec& spec, DatasetPlan& plan) {
  const bool is_whole = !spec.options.formats.empty();
  for (std::size_t sequence = 0; sequence < plan.frames.size(); ++sequence) {
    const std::size_t frames = plan.frames[sequence];
    const auto longest = static_cast<std::size_t>(spec.options.part_frames);
    const std::size_t count =
        is_whole ? std::min<std::size_t>(frames, 1) : (frames + longest - 1) / longest;
    for (std::size_t i = 0; i < count; ++i) {
      plan.parts.push_back({sequence, i, i * frames / count, (i + 1) * frames / count});
    }
  }
  vo::require(plan.parts.size() <= kMaxParts, spec.file.string(), ": ", plan.parts.size(),
              " parts, expected at most ", kMaxParts, "; longer parts are fewer (part_frames)");
}

/// Throws vo::Error of kind output_exists that names the keys in which two identities differ.
void require_same(const std::map<std::string, std::string>& begun,
                  const std::map<std::string, std::string>& wanted, const fs::path& plan_file) {
  constexpr std::size_t kMaxNamed = 8;
  std::map<std::string, std::string> all = begun;
  all.insert(wanted.begin(), wanted.end());
  std::string keys;
  std::size_t count = 0;
  for (const auto& [key, value] : all) {
    const auto a = begun.find(key);
    const auto b = wanted.find(key);
    if (a != begun.end() && b != wanted.end() && a->second == b->second) {
      continue;
    }
    ++count;
    if (count <= kMaxNamed) {
      keys += (keys.empty() ? "" : ", ") + key;
    }
  }
  if (count > 0) {
    vo::fail_as(vo::ErrorKind::output_exists, plan_file.parent_path().string(),
                ": was begun with other values of ", keys,
                count > kMaxNamed ? vo::concat(" and ", count - kMaxNamed, " more") : "",
                "; expected the same spec, or another --out, or that folder removed");
  }
}

}  // namespace

std::size_t DatasetPlan::frame_count() const {
  return cameras * std::accumulate(frames.begin(), frames.end(), std::size_t{0});
}

std::size_t DatasetPlan::sequence_count() const {
  return static_cast<std::size_t>(
      std::count_if(frames.begin(), frames.end(), [](std::size_t count) { return count > 0; }));
}

DatasetPlan make_plan(const DatasetSpec& spec, const vo::Progress& progress) {
  DatasetPlan plan{.identity = identity_of(spec), .cameras = spec.camera_count()};
  plan.frames.resize(spec.sequences.size());
  SequenceJobs jobs(spec);
  for (std::size_t i = 0; i < spec.sequences.size(); ++i) {
    plan_one(spec, i, jobs, plan);
    if (progress) {
      progress(i + 1, spec.sequences.size());
    }
  }
  add_parts(spec, plan);
  return plan;
}

void require_plan_of(const DatasetSpec& spec, const DatasetPlan& plan, const fs::path& plan_file) {
  const std::string place = plan_file.string();
  vo::require(plan.cameras == spec.camera_count(), place, ": cameras: got ", plan.cameras,
              ", expected ", spec.camera_count());
  vo::require(plan.frames.size() == spec.sequences.size(), place, ": sequences: got ",
              plan.frames.size(), ", expected ", spec.sequences.size());
  for (const std::size_t frames : plan.frames) {
    vo::require(frames <= kMaxSequenceFrames, place, ": sequences: ", frames,
                " frames, expected at most ", kMaxSequenceFrames);
  }
  DatasetPlan cut{.frames = plan.frames};
  add_parts(spec, cut);
  vo::require(plan.parts == cut.parts, place, ": parts: ", plan.parts.size(), " that are not the ",
              cut.parts.size(), " into which part_frames cuts the sequences");
}

DatasetPlan begin_dataset(const DatasetSpec& spec, const fs::path& plan_file,
                          vo::Durability durability, const vo::Progress& progress) {
  if (path_exists(plan_file)) {
    DatasetPlan plan = read_plan(plan_file);
    require_same(plan.identity, identity_of(spec), plan_file);
    require_plan_of(spec, plan, plan_file);
    return plan;
  }
  require_own_folder(plan_file);
  DatasetPlan plan = make_plan(spec, progress);
  vo::make_folder(plan_file.parent_path());
  vo::write_unlocked(plan_file, format_sealed_plan(spec, plan), durability);
  return plan;
}

std::vector<std::size_t> shares_by_part(const DatasetPlan& plan, std::size_t shares) {
  std::size_t total = 0;  // frames of all parts, of one camera as each part's are
  for (const DatasetPart& part : plan.parts) {
    total += part.frame_count();
  }
  std::vector<std::size_t> by_part;
  std::size_t before = 0;  // frames of the parts before
  for (const DatasetPart& part : plan.parts) {
    // A part belongs to the share that its middle frame lies in.
    by_part.push_back((2 * before + part.frame_count()) * shares / (2 * total) + 1);
    before += part.frame_count();
  }
  return by_part;
}

std::vector<std::size_t> share_of_parts(const DatasetPlan& plan, std::size_t k, std::size_t n) {
  const std::vector<std::size_t> by_part = shares_by_part(plan, n);
  std::vector<std::size_t> share;
  for (std::size_t part = 0; part < by_part.size(); ++part) {
    if (by_part[part] == k) {
      share.push_back(part);
    }
  }
  return share;
}

std::vector<std::size_t> shares_with(const DatasetPlan& plan, const std::vector<std::size_t>& parts,
                                     std::size_t shares) {
  const std::vector<std::size_t> by_part = shares_by_part(plan, shares);
  std::vector<std::size_t> some;
  for (const std::size_t part : parts) {
    if (some.empty() || some.back() != by_part[part]) {
      some.push_back(by_part[part]);
    }
  }
  return some;
}

}  // namespace tools
