#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "synth/path_planning/path_options.h"
#include "vo/geometry/camera.h"

namespace tools {

/// The camera on a command line.
struct CameraArguments {
  std::string size = "640x480";
  std::string intrinsics;
  std::string camera;
  double fov_deg = 60;
};

void add_camera_options(CLI::App& command, CameraArguments& arguments);

/// Throws vo::Error, of kind usage where it does not lie in a file.
vo::RgbdCamera chosen_camera(const CameraArguments& arguments);

/// The camera's path on a command line.
struct PathArguments {
  std::string kind;
  synth::PathOptions options;
};

void add_path_options(CLI::App& command, PathArguments& arguments);

/// Throws vo::Error of kind usage.
synth::PathOptions chosen_path(const PathArguments& arguments);

}  // namespace tools
