#include <iostream>
#include <memory>
#include <numbers>
#include <string>

#include <nlohmann/json.hpp>

#include "synth/gltf/gltf_summary.h"
#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/commands/commands.h"
#include "tools/json/document.h"

namespace tools {
namespace {

using nlohmann::ordered_json;

constexpr const char* kInspectHelp =
    "Reads a glTF 2.0 scene and says what is in it. triangles, draw_calls and vertices are those\n"
    "of the file, each primitive once, as the Khronos validator counts; bounds are those of the\n"
    "scene's meshes where their nodes put them, before skins, morph targets and\n"
    "EXT_mesh_gpu_instancing; shown_triangles and bounds_at_rest are of what is rendered;\n"
    "sharing_instances have a mesh that is kept once for all of them. Lengths in m, world:\n"
    "right-handed, y up. Exit code 3 and a sentence if it cannot be read.";

constexpr const char* kInspectExamples =
    "Examples:\n"
    "  edvo inspect room.gltf\n"
    "  edvo inspect fox.glb --animation Walk --json";

struct InspectArguments {
  CommonOptions common;
  std::string scene;
  synth::GltfOptions options;
};

ordered_json as_json(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

ordered_json as_json(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) {
    return nullptr;
  }
  return {{"min", as_json(box.min())}, {"max", as_json(box.max())}};
}

constexpr double kDegrees = 180 / std::numbers::pi;

ordered_json as_json(const synth::Light& light) {
  ordered_json json = {{"kind", vo::to_string(light.kind)},
                       {"intensity", as_json(Eigen::Vector3d(light.intensity.cast<double>()))}};
  if (light.kind != synth::LightKind::directional) {
    json["position"] = as_json(light.position);
  }
  if (light.kind != synth::LightKind::point) {
    json["direction"] = as_json(light.direction);
  }
  return json;
}

ordered_json as_json(const synth::SceneCamera& camera) {
  const Eigen::Quaterniond& q = camera.T_world_camera.rotation();
  return {{"name", camera.name},
          {"position", as_json(camera.T_world_camera.translation())},
          {"rotation_xyzw", {q.x(), q.y(), q.z(), q.w()}},
          {"vertical_fov_deg", camera.vertical_fov * kDegrees}};
}

ordered_json as_json(const synth::AnimationSummary& animation) {
  return {
      {"name", animation.name}, {"duration", animation.duration}, {"channels", animation.channels}};
}

template <typename Element>
ordered_json list(const std::vector<Element>& elements) {
  ordered_json json = ordered_json::array();
  for (const Element& element : elements) {
    json.push_back(as_json(element));
  }
  return json;
}

ordered_json as_json(const InspectArguments& arguments, const synth::GltfSummary& summary) {
  return {{"scene", arguments.scene},
          {"triangles", summary.triangles},
          {"draw_calls", summary.draw_calls},
          {"vertices", summary.vertices},
          {"bounds", as_json(summary.bounds)},
          {"bounds_at_rest", as_json(summary.bounds_at_rest)},
          {"scenes", summary.scenes},
          {"nodes", summary.nodes},
          {"instances", summary.scene.instances.size()},
          {"moving_instances", summary.moving_instances},
          {"sharing_instances", summary.sharing_instances},
          {"shown_triangles", summary.shown_triangles},
          {"materials", summary.materials},
          {"textures", summary.textures},
          {"images", summary.images},
          {"skins", summary.skins},
          {"lights", list(summary.scene.lights)},
          {"lights_from_all_sides", !summary.scene.environment.empty()},
          {"cameras", list(summary.scene.cameras)},
          {"animations", list(summary.animations)},
          {"extensions_used", summary.extensions_used},
          {"extensions_required", summary.extensions_required},
          {"notes", summary.notes}};
}

std::string as_text(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) {
    return "none";
  }
  return vo::concat(box.min().transpose(), "  to  ", box.max().transpose(), "  m");
}

std::string as_text(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + (name.empty() ? "(unnamed)" : name);
  }
  return names.empty() ? "none" : text;
}

void print_table(const synth::GltfSummary& summary, const Colours& colours) {
  std::vector<std::string> animations;
  for (const synth::AnimationSummary& animation : summary.animations) {
    animations.push_back(vo::concat(animation.name, " (", animation.duration, " s)"));
  }
  std::vector<std::string> cameras;
  for (const synth::SceneCamera& camera : summary.scene.cameras) {
    cameras.push_back(camera.name);
  }
  std::cout << "triangles       " << summary.triangles << " in " << summary.draw_calls
            << " draw calls, " << summary.vertices << " vertices\n"
            << "instances       " << summary.scene.instances.size() << ", "
            << summary.moving_instances << " moving, " << summary.sharing_instances
            << " sharing a mesh; they show " << summary.shown_triangles << " triangles\n"
            << "bounds          " << as_text(summary.bounds) << "\n"
            << "bounds at rest  " << as_text(summary.bounds_at_rest) << "\n"
            << "scenes          " << as_text(summary.scenes) << "\n"
            << "materials       " << as_text(summary.materials) << "\n"
            << "textures        " << summary.textures << " of " << summary.images << " images\n"
            << "lights          " << summary.scene.lights.size()
            << (summary.scene.environment.empty() ? "" : ", and light from all sides") << "\n"
            << "cameras         " << as_text(cameras) << "\n"
            << "animations      " << as_text(animations) << "\n"
            << "extensions      " << as_text(summary.extensions_used) << "\n"
            << "  required      " << as_text(summary.extensions_required) << "\n";
  for (const std::string& note : summary.notes) {
    std::cout << colours.paint(Tone::caution, "note") << "            " << note << "\n";
  }
}

void inspect(const InspectArguments& arguments, const Session& session) {
  ProgressBar bar("reading " + arguments.scene, arguments.common.verbosity());
  bar.announce();
  const synth::GltfSummary summary = synth::summarize_gltf(arguments.scene, arguments.options);
  bar.erase();
  if (arguments.common.json) {
    std::cout << json_text(json_document({"inspect"}, as_json(arguments, summary)));
  } else {
    print_table(summary, session.out);
  }
}

}  // namespace

void add_inspect_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("inspect", kInspectHelp);
  const auto arguments = std::make_shared<InspectArguments>();
  command.footer(kInspectExamples);
  command.add_option("SCENE", arguments->scene, "glTF 2.0 file, .gltf or .glb")->required();
  add_scene_options(command, arguments->options);
  add_common_options(command, arguments->common);
  take_streams(command, {.inputs = {"SCENE"}});
  command.callback([arguments, &session] { inspect(*arguments, session); });
}

}  // namespace tools
