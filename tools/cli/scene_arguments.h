#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "synth/gltf/gltf.h"
#include "synth/path_planning/path_options.h"
#include "vo/geometry/camera_model.h"

namespace tools {

/// Adds the options of a scene's file, of which `scale` is named --scene-scale.
void add_scene_options(CLI::App& command, synth::GltfOptions& options);

/// Adds the option `--actor` of a file of actors.
void add_actor_option(CLI::App& command, std::string& file);

/// Command-line options of the camera.
struct CameraArguments {
  std::string size = "640x480";
  std::string intrinsics;
  std::string camera;
  double fov_deg = 60;
};

void add_camera_options(CLI::App& command, CameraArguments& arguments);

/// Returns the camera. Throws vo::Error, of kind usage unless the error is in a camera file.
vo::RgbdCameraModel chosen_camera(const CameraArguments& arguments);

/// Adds the option `--camera` of the commands that read a sequence.
void add_camera_option(CLI::App& command, std::string& preset_or_file);

/// Returns the camera that replaces the sequence's own, if one was given.
std::optional<vo::RgbdCamera> given_camera(const std::string& preset_or_file);

/// Command-line options of the camera's path.
struct PathArguments {
  std::string kind;
  synth::PathOptions options;
};

void add_path_options(CLI::App& command, PathArguments& arguments);

/// Returns the options of the chosen path. Throws vo::Error of kind usage.
synth::PathOptions chosen_path(const PathArguments& arguments);

}  // namespace tools
