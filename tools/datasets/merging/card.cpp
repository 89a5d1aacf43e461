#include "tools/datasets/merging/card.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "tools/datasets/layout.h"
#include "tools/plot/table.h"
#include "vo/core/error.h"
#include "vo/core/version.h"

namespace tools {
namespace {

/// What the sequences of one split have together.
struct SplitTotals {
  std::size_t sequences = 0;
  std::size_t frames = 0;
  double duration_s = 0;
  double length_m = 0;
  std::set<std::string> scenes;
};

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

std::string splits_table(const DatasetIndex& index) {
  std::map<std::string, SplitTotals> splits;
  for (const auto& [sequence, statistics] : index.sequences()) {
    SplitTotals& totals = splits[sequence->split];
    ++totals.sequences;
    totals.frames += statistics.frames;
    totals.duration_s += statistics.duration_s;
    totals.length_m += statistics.length_m;
    totals.scenes.insert(sequence->scene);
  }
  Table table{
      .columns = {{"split"}, {"scenes"}, {"sequences"}, {"frames"}, {"minutes", 1}, {"m", 1}}};
  constexpr double kSecondsPerMinute = 60;
  for (const auto& [split, totals] : splits) {
    table.add_row({split, joined(totals.scenes), static_cast<double>(totals.sequences),
                   static_cast<double>(totals.frames), totals.duration_s / kSecondsPerMinute,
                   totals.length_m});
  }
  return as_markdown(table);
}

std::string licences_table(const DatasetIndex& index) {
  std::map<std::string, std::string> licences;
  for (const auto& [sequence, statistics] : index.sequences()) {
    licences[sequence->scene] = sequence->licence;
  }
  Table table{.columns = {{"scene"}, {"licence"}}};
  for (const auto& [scene, licence] : licences) {
    table.add_row({scene, licence});
  }
  return as_markdown(table);
}

/// Returns the sequences, evenly spread, whose pictures and figures the card shows.
std::vector<std::size_t> shown(const DatasetIndex& index, std::size_t most) {
  const std::size_t count = std::min(index.sequences().size(), most);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    chosen.push_back(i * index.sequences().size() / count);
  }
  return chosen;
}

std::string sequences_table(const DatasetIndex& index) {
  constexpr std::size_t kMostRows = 60;
  Table table{.columns = {{"sequence"},
                          {"frames"},
                          {"m", 2},
                          {"flow, px", 2},
                          {"blur, px", 2},
                          {"depth, %", 1},
                          {"texture, %", 1}}};
  constexpr double kPercent = 100;
  const std::vector<std::size_t> chosen = shown(index, kMostRows);
  for (const std::size_t i : chosen) {
    const auto& [sequence, statistics] = index.sequences()[i];
    table.add_row({sequence->name, static_cast<double>(statistics.frames), statistics.length_m,
                   statistics.flow_px, statistics.blur_px, kPercent * statistics.depth_coverage,
                   kPercent * statistics.textured_share});
  }
  const std::size_t all = index.sequences().size();
  return as_markdown(table) + (chosen.size() < all ? vo::concat("\n", chosen.size(), " of ", all,
                                                                "; all are in sequences.csv.\n")
                                                   : "");
}

std::string pictures_table(const DatasetIndex& index) {
  constexpr std::size_t kMostPictures = 12;
  constexpr std::size_t kColumns = 3;
  std::string text = "| | | |\n|---|---|---|\n";
  std::size_t column = 0;
  for (const std::size_t i : shown(index, kMostPictures)) {
    const std::string& name = index.sequences()[i].first->name;
    text += vo::concat("| ![", name, "](pictures/", name, ".webp)<br>", name, " ");
    column = (column + 1) % kColumns;
    text += column == 0 ? "|\n" : "";
  }
  while (column % kColumns != 0) {
    text += "| ";
    column = (column + 1) % kColumns;
    text += column == 0 ? "|\n" : "";
  }
  return text;
}

/// Returns what the card says of the folder of a sequence that a rig took; nothing without a rig.
std::string rig_item(const DatasetSpec& spec) {
  if (!spec.rig) {
    return {};
  }
  std::string names;
  for (const vo::RigCamera& camera : spec.rig->cameras) {
    names += (names.empty() ? "" : ", ") + camera.name;
  }
  const std::vector<synth::TruthChannel> channels = spec.channels();
  const bool has_imu =
      std::find(channels.begin(), channels.end(), synth::TruthChannel::imu) != channels.end();
  return vo::concat("- `SPLIT/SCENE/SEQUENCE/`: what a rig saw, of cameras ", names,
                    ". `rig.toml` says where they are on the body, `groundtruth.txt` has "
                    "T_world_body",
                    has_imu ? ", `imu.csv` what the body's IMU measured" : "",
                    ". Frames are counted of all cameras; minutes and m are the first one's.\n");
}

std::string files_section(const DatasetSpec& spec) {
  const bool is_archive = spec.options.tar;
  std::string text = vo::concat(
      "## Files\n\n", rig_item(spec), "- `SPLIT/SCENE/SEQUENCE/", spec.rig ? "CAMERA/" : "",
      "`: a sequence in the layout of the TUM RGB-D benchmark",
      is_archive ? ", its frames in archives `SEQUENCE-000.tar`, which WebDataset reads" : "",
      ". `groundtruth.txt` has T_world_camera (camera x right, y down, z forward), `camera.toml` "
      "the camera, `sequence.toml` all conventions and what it was made of.\n");
  if (!spec.options.channels.empty()) {
    text += "- `truth/`: exact " + spec.options.channels + " of what a perfect camera would see.\n";
  }
  for (const vo::WrittenSequence format : spec.formats()) {
    text += vo::concat("- `SPLIT/SCENE/SEQUENCE.", vo::to_string(format),
                       "`: the same sequence as ", vo::to_string(format), ".\n");
  }
  return text +
         "- `frames.csv`: a row for each frame: paths, pose, median flow to the next frame and "
         "what "
         "of it blurs (px), shares of depth and texture, clearance (m).\n"
         "- `sequences.csv`: a row for each sequence, with means over its frames.\n"
         "- `checksums.sha256`: `sha256sum --check` or `edvo dataset verify`.\n";
}

std::string rejected_section(const DatasetPlan& plan) {
  if (plan.rejected.empty()) {
    return {};
  }
  Table table{.columns = {{"sequence"}, {"reason"}}};
  for (const RejectedSequence& sequence : plan.rejected) {
    table.add_row({sequence.name, sequence.reason});
  }
  return "## Left out\n\n" + as_markdown(table) + "\n";
}

}  // namespace

std::string dataset_card(const DatasetSpec& spec, const DatasetPlan& plan,
                         const DatasetIndex& index) {
  const std::string name = spec.options.name;
  return vo::concat(
      "# ", name, "\n\n", spec.options.about, spec.options.about.empty() ? "" : "\n\n",
      splits_table(index), "\n", pictures_table(index), "\n",
      "![Distributions of flow, depth and texture](statistics.svg)\n\n", files_section(spec), "\n",
      "## Sequences\n\nMeans over the frames.\n\n", sequences_table(index), "\n",
      rejected_section(plan), "## Licences\n\n", licences_table(index), "\n",
      "## Made by\n\n    edvo dataset render dataset.toml --out ", name,
      "\n    edvo dataset merge dataset.toml --out ", name, "\n\nof edvo ", vo::version(),
      ", with the scenes ", spec.rig ? "and the rig " : "",
      "where dataset.toml says. The bytes are the same on any number of "
      "processes and machines; dataset.json has what determines them.\n");
}

}  // namespace tools
