#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "synth/camera/metering.h"
#include "synth/camera/renderers_over_time.h"
#include "synth/gltf/scene_file.h"
#include "synth/rendering/renderer.h"
#include "synth/sensor/sensor.h"
#include "tools/python/arrays.h"
#include "tools/python/bindings.h"
#include "tools/python/options.h"
#include "vo/core/error.h"

namespace python {

namespace py = pybind11;

namespace {

/// A scene with what was left out of its file.
struct PyScene {
  synth::Scene scene;
  synth::Notes notes;
};

/// Renderers of a scene, and what a camera makes of it.
struct PyRenderer {
  std::shared_ptr<const PyScene> scene;
  synth::SensorOptions sensor;
  synth::RenderersOverTime renderers;
};

/// Returns the actors that a list of dicts describes, with the keys of a table `[[actor]]`.
std::vector<synth::ActorOptions> actors_of(const std::vector<py::dict>& dicts) {
  std::vector<synth::ActorOptions> actors;
  for (const py::dict& dict : dicts) {
    synth::ActorOptions& actor = actors.emplace_back();
    std::vector<vo::Field> fields = vo::fields_of(actor);
    assign_dict(fields, dict);
    actor.validate();
  }
  return actors;
}

std::shared_ptr<PyScene> load_scene(const std::string& path, const std::string& environment,
                                    double environment_turn, double environment_strength,
                                    const std::vector<py::dict>& dicts) {
  std::vector<synth::ActorOptions> actors = actors_of(dicts);
  const py::gil_scoped_release no_gil;
  synth::GltfOptions options;
  options.environment = environment;
  options.environment_turn = environment_turn;
  options.environment_strength = environment_strength;
  const synth::SceneFile file(path, options, std::move(actors));
  return std::make_shared<PyScene>(PyScene{file.scene(), file.notes()});
}

PyRenderer make_renderer(const std::shared_ptr<PyScene>& scene,
                         const std::optional<synth::RenderOptions>& options, double exposure) {
  const py::gil_scoped_release no_gil;
  synth::SensorOptions sensor;
  sensor.exposure = exposure;
  sensor.validate();
  return {scene, sensor,
          synth::RenderersOverTime(scene->scene, options ? *options : synth::RenderOptions{})};
}

synth::Channels channels_of(const std::vector<std::string>& names) {
  synth::Channels channels{.color = false, .depth = false};
  for (const std::string& name : names) {
    switch (vo::parse_choice(name, {"image", "depth", "normal", "ids", "depth_beyond"})) {
      case 0:
        channels.color = true;
        break;
      case 1:
        channels.depth = true;
        break;
      case 2:
        channels.normal = true;
        break;
      case 3:
        channels.ids = true;
        break;
      default:
        channels.sight = true;
    }
  }
  return channels;
}

/// Renders a camera at rest and the scene as it is at a time, s. The image has the sensor's
/// exposure or, where that is 0, is metered.
py::dict render(const PyRenderer& self, const vo::RgbdCamera& camera,
                const Eigen::Matrix4d& T_world_camera, const std::vector<std::string>& names,
                double time) {
  vo::require(std::isfinite(time), "time: expected a number of seconds, got ", time);
  synth::Capture capture = synth::still(camera.pinhole, motion_of(T_world_camera));
  capture.channels = channels_of(names);
  capture.scene_time = time;
  synth::RenderedFrame frame;
  cv::Mat image;
  {
    const py::gil_scoped_release no_gil;
    const std::shared_ptr<const synth::Renderer> renderer = self.renderers.at(time);
    frame = renderer->render(capture);
    vo::require(!capture.channels.sight || !frame.sight.beyond.empty(),
                "depth_beyond: is made by the ray tracer alone");
    if (capture.channels.color) {
      synth::FrameSetting setting;
      setting.exposure_time = self.sensor.shutter.exposure_time;
      setting.exposure =
          self.sensor.exposure > 0
              ? self.sensor.exposure
              : synth::meter(*renderer, camera.pinhole, motion_of(T_world_camera)).exposure;
      image = synth::develop(frame.radiance, camera.pinhole, self.sensor, setting);
    }
  }
  py::dict result;
  result["image"] = shared_array(image);
  result["radiance"] = shared_array(frame.radiance);
  result["depth"] = shared_array(frame.depth);
  result["depth_beyond"] = shared_array(frame.sight.beyond);
  result["normal"] = shared_array(frame.normal);
  result["instance"] = shared_array(frame.instance);
  result["material"] = shared_array(frame.material);
  return result;
}

}  // namespace

void bind_rendering(py::module_& module) {
  py::class_<PyScene, std::shared_ptr<PyScene>>(module, "Scene", "A glTF 2.0 scene.")
      .def(
          py::init(&load_scene), py::arg("path"), py::arg("environment") = "",
          py::arg("environment_turn") = 0.0, py::arg("environment_strength") = 1.0,
          py::arg("actors") = std::vector<py::dict>{},
          "environment: equirectangular image of light from all sides (.hdr, .exr), turned in deg\n"
          "actors: dicts of what goes through the scene, with the keys of a table [[actor]]")
      .def_readonly("notes", &PyScene::notes, "what was left out of the file")
      .def_property_readonly("meshes", [](const PyScene& s) { return s.scene.meshes.size(); })
      .def_property_readonly(
          "cameras",
          [](const PyScene& s) {
            py::dict cameras;
            for (const synth::SceneCamera& camera : s.scene.cameras) {
              cameras[py::str(camera.name)] = matrix_of(camera.T_world_camera);
            }
            return cameras;
          },
          "T_world_camera of the file's cameras by name");
  py::class_<synth::RenderOptions> options(module, "RenderOptions", "How a scene is rendered.");
  options.def(py::init<>());
  bind_fields(options);
  py::class_<PyRenderer>(module, "Renderer", "Renders a scene with exact depth.")
      .def(py::init(&make_renderer), py::arg("scene"), py::arg("options") = py::none(),
           py::arg("exposure") = 0.0, "exposure: gain from radiance to 0..1; 0 meters each picture")
      .def(
          "render", &render, py::arg("camera"), py::arg("T_world_camera"),
          py::arg("channels") = std::vector<std::string>{"image", "depth"}, py::arg("time") = 0.0,
          "Return a dict of arrays: image, radiance, depth (m), depth_beyond (m, behind glass and\n"
          "in mirrors), normal, instance, material; None for what `channels` (image, depth,\n"
          "normal, ids, depth_beyond) does not ask for. `time` is that of the scene, s.");
}

}  // namespace python
