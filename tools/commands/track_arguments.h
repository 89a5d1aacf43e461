#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/cli/options.h"
#include "vo/geometry/camera.h"

namespace tools {

/// The command line of `edvo track`.
struct TrackArguments {
  CommonOptions common;
  std::string sequence;
  std::string camera;
  std::string mode = "rgbd";
  std::string bootstrap;
  std::string depth_file;
  std::string preset_name = "default";
  std::vector<std::string> assignments;
  std::string out;
  std::string frame_log;
  int debug_images = 0;
  double max_time_difference = 0.02;
};

/// `--mode mono`; the exit code.
int track_mono(const TrackArguments& arguments, const std::optional<vo::RgbdCamera>& camera);

/// The keys of `--set` in that mode, with their values.
std::string describe_mono_fields();

}  // namespace tools
