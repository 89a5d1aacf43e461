#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "synth/path_planning/path_check.h"
#include "synth/truth/truth_channels.h"
#include "tools/scenario/scenario.h"
#include "vo/exports/sequence_target.h"
#include "vo/rigs/rig.h"
#include "vo/text_files/toml_file.h"

namespace tools {

/// The limits that a sequence's path must keep for the sequence to be made; 0 = no limit.
struct DatasetFilter {
  synth::PathLimits limits;
  double min_mean_flow_px = 0;  ///< px, mean over the frames of their median optical flow
  double max_mean_flow_px = 0;  ///< px

  bool is_empty() const;  ///< returns whether there is no limit
  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, DatasetFilter& filter) {
  visit_fields(visit, filter.limits);
  visit("min_mean_flow_px", filter.min_mean_flow_px, "mean over the frames of their flow, px");
  visit("max_mean_flow_px", filter.max_mean_flow_px, "mean over the frames of their flow, px");
}

/// What of a data set is the same for all its sequences.
struct DatasetOptions {
  std::string name;       ///< letters, digits and '-'
  std::string about;      ///< a sentence for the data set's card
  std::string rig;        ///< file of the cameras that take every sequence; empty: one camera
  int seeds = 1;          ///< number of sequences of each combination
  int part_frames = 500;  ///< greatest number of a camera's frames that are made together
  bool tar = false;       ///< whether the frames of a part are one archive
  bool float_depth = false;
  std::string channels;  ///< exact truth, as `edvo render --channels` takes it
  std::string formats;   ///< WrittenSequence names of further formats, separated by commas

  void validate() const;  ///< throws vo::Error if out of range
};

template <typename Visitor>
void visit_fields(Visitor& visit, DatasetOptions& options) {
  visit("name", options.name, "of the data set: letters, digits and -");
  visit("about", options.about, "a sentence for the data set's card");
  visit("rig", options.rig, "file of the cameras on one body that take every sequence");
  visit("seeds", options.seeds, "number of sequences of each combination");
  visit("part_frames", options.part_frames,
        "greatest number of a camera's frames that are made together");
  visit("tar", options.tar, "whether the frames of a part are one archive, as WebDataset has it");
  visit("float_depth", options.float_depth, "whether depth is written as float32 metres, too");
  visit("channels", options.channels, "exact truth, as of edvo render --channels");
  visit("formats", options.formats, "further formats, as of edvo convert --format, with commas");
}

/// One sequence of a data set: what is rendered, and where it belongs.
struct DatasetSequence {
  std::string name;    ///< SCENE_PATH_SENSOR_SEED
  std::string scene;   ///< name of the scene in the spec
  std::string path;    ///< name of the path
  std::string sensor;  ///< name of the sensor; empty where the spec names none
  int seed = 0;
  std::string split;    ///< train, val, test, or as the spec says; the same for a scene's sequences
  std::string licence;  ///< of the scene
  Scenario scenario;    ///< scene, camera, path, rendering and sensor
};

/// A data set as its file describes it.
struct DatasetSpec {
  std::filesystem::path file;
  DatasetOptions options;
  DatasetFilter filter;
  std::vector<vo::TomlValue> values;       ///< all that the file says, sorted by key
  std::vector<DatasetSequence> sequences;  ///< by scene, path, sensor and seed, names sorted
  std::optional<vo::Rig> rig;              ///< whose cameras take every sequence; none: one camera

  std::vector<synth::TruthChannel> channels() const;
  std::vector<vo::WrittenSequence> formats() const;  ///< beside TUM's
  std::filesystem::path rig_file() const;            ///< absolute; requires a rig
  std::size_t camera_count() const { return rig ? rig->cameras.size() : 1; }
};

/// Loads a spec: tables [camera], [render], [path] and [sensor] as in a scenario, where all
/// sequences start from; [scenes.NAME], [paths.NAME] and [sensors.NAME], every combination of which
/// is a sequence with each seed; [filter]; `rig`, which takes the place of the camera. Throws
/// vo::Error as `file:line: ...` for what is wrong, and names all scene files that are missing.
DatasetSpec load_dataset_spec(const std::filesystem::path& file);

}  // namespace tools
