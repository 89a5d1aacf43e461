#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tools/cli/live_arguments.h"
#include "tools/cli/options.h"
#include "tools/cli/standard_streams.h"
#include "tools/colour/colour.h"
#include "vo/recordings/sequence_topics.h"
#include "vo/text_files/toml_file.h"

namespace tools {

/// Errors name the file of all options beside `--out` by these words; `--config` may be the same.
inline constexpr const char* kOptionsBesideOut = "the options beside --out";

/// The endings of what `edvo track` writes beside `--out`.
inline constexpr const char* kConfigEnding = "_config.toml";
inline constexpr const char* kPanelsEnding = "_panels";
inline constexpr const char* kPlotEnding = "_trajectory.svg";

/// The odometry that tracks.
enum class TrackMode { rgbd, mono };

constexpr auto enum_names(TrackMode) {
  return std::array{std::pair{TrackMode::rgbd, "rgbd"}, std::pair{TrackMode::mono, "mono"}};
}

/// The command line of `edvo track`, and the configuration file that it names.
struct TrackArguments {
  CommonOptions common;
  LiveArguments live;
  std::string sequence;
  std::string camera;
  std::string mode;    ///< name of a TrackMode; empty: as the configuration says, else rgbd
  std::string preset;  ///< of mode rgbd; empty: as the configuration says, else default
  std::string config;  ///< TOML file with keys as --set takes them; empty without one
  std::string bootstrap;
  std::string depth_file;
  std::vector<std::string> assignments;  ///< key=value, applied after the configuration
  std::string out;
  std::string frame_log;
  std::string time_log;
  std::string save_map;  ///< .ply or .pcd for the keyframes' points; empty without one
  int debug_images = 0;
  std::size_t frames = 0;                  ///< of a camera, at most; 0 = any number
  std::string size;                        ///< of a camera's images, WxH, px; empty = its own
  double max_time_difference = 0.02;       ///< s
  vo::SequenceTopics topics;               ///< of a recording
  std::vector<vo::TomlValue> config_keys;  ///< of the configuration, without mode and preset
};

/// Reads the configuration file, if there is one: `mode` and `preset` count where the command line
/// names none. Throws vo::Error with file:line, and of kind usage where the command line has
/// options of the other mode.
void read_config(TrackArguments& arguments);

/// Sets the fields that the configuration and --set name, in this order; notes on stderr in these
/// colours. Throws vo::Error.
void apply_arguments(const TrackArguments& arguments, std::vector<vo::Field>& fields,
                     const Colours& colours);

/// Writes all that a run was tracked with, so that `--config` repeats it, beside the trajectory:
/// `estimate_config.toml` for `estimate.txt`; nothing where the trajectory goes to stdout.
void write_config(const TrackArguments& arguments, const std::vector<vo::Field>& fields);

/// Returns the files and folders that are written beside `--out` without being named: the options,
/// and where they are asked for the pictures and the plot.
std::vector<NamedPlace> places_beside(const TrackArguments& arguments);

/// The path of a file with another ending: `a/e_panels` for `a/e.txt` and `_panels`.
std::filesystem::path beside(const std::filesystem::path& file, const std::string& suffix);

}  // namespace tools
