#include <array>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "synth/path_planning/path_check.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"
#include "tools/scenario/actor_tables.h"

namespace tools {
namespace {

constexpr const char* kCheckHelp =
    "Says what a camera path does in a scene, before anything is rendered: least distance to any\n"
    "surface, collisions, blank views, speed, acceleration, optical flow. Each frame sees the "
    "scene\n"
    "as it is then: a collision is also where a moving thing runs into the camera. Flow is the\n"
    "camera's own. Exit code 4 where a limit that is given is not kept.";

constexpr const char* kPathExamples =
    "Examples:\n"
    "  edvo path check room.gltf --path explore --explore.seed 3 --json\n"
    "  edvo path check room.gltf --trajectory poses.txt --limit.min-clearance 0.2 \\\n"
    "       --limit.max-turn-deg 60 --limit.max-flow-px 30";

struct CheckArguments {
  CommonOptions common;
  std::string scene;
  synth::GltfOptions file;
  std::string actors;
  CameraArguments camera;
  PathArguments path;
  synth::PathLimits limits;
};

/// A quantity of the report: name, unit and its member.
struct Quantity {
  const char* name;
  const char* unit;
  double synth::FrameCheck::*value;
};

constexpr std::array kQuantities = {
    Quantity{"clearance", "m", &synth::FrameCheck::clearance},
    Quantity{"speed", "m/s", &synth::FrameCheck::speed},
    Quantity{"turn_deg", "deg/s", &synth::FrameCheck::turn_deg},
    Quantity{"acceleration", "m/s^2", &synth::FrameCheck::acceleration},
    Quantity{"flow_px", "px", &synth::FrameCheck::flow_px},
    Quantity{"depth_share", "of pixels", &synth::FrameCheck::depth_share},
    Quantity{"textured_share", "of tiles", &synth::FrameCheck::textured_share}};

nlohmann::ordered_json to_json(const synth::PathReport& report) {
  nlohmann::ordered_json json = {{"frames", report.frames.size()},
                                 {"duration", report.duration},
                                 {"length", report.length},
                                 {"collisions", report.collisions},
                                 {"blank_views", report.blank_views}};
  for (const Quantity& quantity : kQuantities) {
    const synth::Range range = synth::range_of(report.frames, quantity.value);
    json[quantity.name] = {{"min", range.min}, {"median", range.median}, {"max", range.max}};
  }
  json["violations"] = report.violations;
  nlohmann::ordered_json& frames = json["per_frame"];
  for (const synth::FrameCheck& frame : report.frames) {
    nlohmann::ordered_json values = {{"time", frame.time}};
    for (const Quantity& quantity : kQuantities) {
      values[quantity.name] = frame.*quantity.value;
    }
    frames.push_back(values);
  }
  return json;
}

void print(const synth::PathReport& report, const Colours& colours) {
  std::cout << std::fixed << std::setprecision(3) << report.frames.size() << " frames, "
            << report.duration << " s, " << report.length << " m; " << report.collisions
            << " collisions, " << report.blank_views << " blank views\n"
            << std::left << std::setw(16) << "" << std::right << std::setw(10) << "min"
            << std::setw(10) << "median" << std::setw(10) << "max"
            << "\n";
  for (const Quantity& quantity : kQuantities) {
    const synth::Range range = synth::range_of(report.frames, quantity.value);
    std::cout << std::left << std::setw(16) << quantity.name << std::right << std::setw(10)
              << range.min << std::setw(10) << range.median << std::setw(10) << range.max << "  "
              << quantity.unit << "\n";
  }
  for (const std::string& violation : report.violations) {
    std::cout << colours.paint(Tone::bad, "violated") << ": " << violation << "\n";
  }
}

void check(const CheckArguments& arguments, Session& session) {
  const vo::RgbdCameraModel camera = chosen_camera(arguments.camera);
  check_usage([&] {
    camera.validate();
    arguments.limits.validate();
  });
  ProgressBar bar("checking", arguments.common.verbosity());
  bar.announce("checking the path in " + arguments.scene);
  const synth::SceneFile file(arguments.scene, arguments.file, load_actors(arguments.actors));
  const synth::TimedPath timed = synth::make_path(chosen_path(arguments.path), file);
  const synth::PathReport report =
      synth::check_path(file.scene(), camera.model, timed, arguments.limits);
  bar.erase();
  if (arguments.common.json) {
    std::cout << json_text(json_document({"path_check"}, to_json(report)));
  } else {
    print(report, session.out);
  }
  if (!report.violations.empty()) {
    session.status = exit_code::kBoundViolated;
  }
}

}  // namespace

void add_path_command(CLI::App& program, Session& session) {
  CLI::App& path = *program.add_subcommand("path", "Camera paths: see `edvo path check --help`.");
  path.require_subcommand(1);
  CLI::App& command = *path.add_subcommand("check", kCheckHelp);
  const auto arguments = std::make_shared<CheckArguments>();
  command.footer(kPathExamples);
  command.add_option("SCENE", arguments->scene, "glTF 2.0 file, .gltf or .glb")->required();
  add_camera_options(command, arguments->camera);
  add_path_options(command, arguments->path);
  add_scene_options(command, arguments->file);
  add_actor_option(command, arguments->actors);
  add_field_options(command, vo::fields_of(arguments->limits, "limit."), "Limits, 0 = none");
  add_common_options(command, arguments->common);
  take_streams(command,
               {.inputs = {"SCENE", "--trajectory"}, .configurations = {"--camera", "--actor"}});
  command.callback([arguments, &session] { check(*arguments, session); });
}

}  // namespace tools
