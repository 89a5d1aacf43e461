#include "tools/commands/track_arguments.h"

#include <algorithm>

#include "vo/core/version.h"
#include "vo/odometry/rgbd_odometry.h"

namespace tools {
namespace {

/// Takes a key out of the values; leaves `chosen` as it is unless it is empty.
void take_key(std::vector<vo::TomlValue>& values, const std::string& key,
              const std::vector<std::string_view>& choices, std::string& chosen) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const vo::TomlValue& value) { return value.key == key; });
  if (found == values.end()) {
    return;
  }
  try {
    vo::parse_choice(found->text, choices);
  } catch (const vo::Error& error) {
    vo::fail(found->place, ": ", key, ": ", error.what());
  }
  if (chosen.empty()) {
    chosen = found->text;
  }
  values.erase(found);
}

/// Throws where an option is given that counts in another mode alone.
void refuse_for_other_mode(bool is_given, const char* option, TrackMode mode, TrackMode expected) {
  if (is_given && mode != expected) {
    vo::fail_as(vo::ErrorKind::usage, option, ": --mode ", vo::to_string(mode),
                " has no use for it, expected it with --mode ", vo::to_string(expected), " alone");
  }
}

/// Returns the line of the preset, which only one of the modes has.
std::string preset_line(const TrackArguments& arguments) {
  return vo::parse_enum<TrackMode>(arguments.mode) == TrackMode::rgbd
             ? vo::concat("preset = ", vo::quoted_toml(arguments.preset), "\n")
             : "";
}

}  // namespace

void read_config(TrackArguments& arguments) {
  const bool is_preset_given = !arguments.preset.empty();
  if (!arguments.config.empty()) {
    arguments.config_keys = vo::read_toml(arguments.config);
  }
  take_key(arguments.config_keys, "mode", vo::names_of<TrackMode>(), arguments.mode);
  take_key(arguments.config_keys, "preset", vo::names_of<vo::TrackerPreset>(), arguments.preset);
  if (arguments.mode.empty()) {
    arguments.mode = vo::to_string(TrackMode::rgbd);
  }
  const auto mode = vo::parse_enum<TrackMode>(arguments.mode);
  refuse_for_other_mode(is_preset_given, "--preset", mode, TrackMode::rgbd);
  refuse_for_other_mode(!arguments.bootstrap.empty(), "--bootstrap", mode, TrackMode::mono);
  refuse_for_other_mode(!arguments.depth_file.empty(), "--depth-file", mode, TrackMode::mono);
  if (arguments.preset.empty()) {
    arguments.preset = vo::to_string(vo::TrackerPreset::best_measured);
  }
}

void apply_arguments(const TrackArguments& arguments, std::vector<vo::Field>& fields,
                     const Colours& colours) {
  vo::assign_fields(arguments.config_keys, fields);
  for (const std::string& assignment : arguments.assignments) {
    apply_assignment(assignment, fields, colours);
  }
}

void write_config(const TrackArguments& arguments, const std::vector<vo::Field>& fields) {
  if (vo::is_stream(arguments.out)) {
    return;
  }
  const std::string text =
      vo::concat("# edvo ", vo::version(), ": all that the trajectory was tracked with.\n",
                 "mode = ", vo::quoted_toml(arguments.mode), "\n", preset_line(arguments),
                 vo::format_toml(fields));
  vo::write_file(beside(arguments.out, kConfigEnding), text, arguments.common.output_policy());
}

std::vector<NamedPlace> places_beside(const TrackArguments& arguments) {
  if (vo::is_stream(arguments.out)) {
    return {};
  }
  std::vector<NamedPlace> places{{kOptionsBesideOut, beside(arguments.out, kConfigEnding)}};
  if (arguments.debug_images > 0) {
    places.push_back({"--debug-images", beside(arguments.out, kPanelsEnding)});
    places.push_back({"--debug-images", beside(arguments.out, kPlotEnding)});
  }
  return places;
}

std::filesystem::path beside(const std::filesystem::path& file, const std::string& suffix) {
  std::filesystem::path path = file;
  path.replace_extension();
  path += suffix;
  return path;
}

}  // namespace tools
