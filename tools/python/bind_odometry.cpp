#include <optional>
#include <string>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "tools/python/arrays.h"
#include "tools/python/bindings.h"
#include "tools/python/options.h"
#include "vo/core/fields.h"
#include "vo/odometry/mono_odometry.h"
#include "vo/odometry/rgbd_odometry.h"
#include "vo/tracking/tracker.h"

namespace python {

namespace py = pybind11;

namespace {

/// An odometry with the camera that says what its depth images mean.
template <typename Odometry>
struct Tracked {
  vo::RgbdCamera camera;
  Odometry odometry;
};

using PyRgbd = Tracked<vo::RgbdOdometry>;
using PyMono = Tracked<vo::MonoOdometry>;

vo::TrackerOptions tracker_options(const std::string& preset) {
  return vo::preset_options(vo::parse_enum<vo::TrackerPreset>(preset));
}

PyRgbd rgbd_odometry(const vo::RgbdCamera& camera, const std::optional<vo::TrackerOptions>& options,
                     const std::optional<Eigen::Matrix4d>& T_world_first) {
  const vo::TrackerOptions given = options ? *options : tracker_options("default");
  return {camera, vo::RgbdOdometry(camera.pinhole, given.starting_from(camera),
                                   T_world_first ? motion_of(*T_world_first) : vo::SE3())};
}

PyMono mono_odometry(const vo::RgbdCamera& camera, const std::optional<vo::MonoOptions>& options,
                     const std::optional<Eigen::Matrix4d>& T_world_first) {
  vo::MonoOptions started = options ? *options : vo::mono_options();
  started.tracker = started.tracker.starting_from(camera);
  return {camera, vo::MonoOdometry(camera.pinhole, started,
                                   T_world_first ? motion_of(*T_world_first) : vo::SE3())};
}

template <typename Odometry>
auto track_frame(Tracked<Odometry>& tracked, const vo::RgbdFrame& frame) {
  const py::gil_scoped_release no_gil;
  return tracked.odometry.track(frame);
}

auto track_rgbd(PyRgbd& tracked, double timestamp, const py::array& image,
                const std::optional<py::array>& depth, double depth_delay) {
  vo::RgbdFrame frame = frame_of(timestamp, image, depth, tracked.camera);
  frame.depth_delay = depth_delay;
  return track_frame(tracked, frame);
}

auto track_mono(PyMono& tracked, double timestamp, const py::array& image,
                const std::optional<py::array>& depth) {
  return track_frame(tracked, frame_of(timestamp, image, depth, tracked.camera));
}

/// Returns the points of a frame, one row of each array for each: px, m in the frame's camera, m.
py::dict points_dict(const vo::EdgePointLevel& points) {
  const auto count = static_cast<py::ssize_t>(points.size());
  py::array_t<int> pixels({count, py::ssize_t{2}});
  py::array_t<float> positions({count, py::ssize_t{3}});
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    pixels.mutable_at(i, 0) = points.pixel[k].x;
    pixels.mutable_at(i, 1) = points.pixel[k].y;
    positions.mutable_at(i, 0) = points.x_ref[k];
    positions.mutable_at(i, 1) = points.y_ref[k];
    positions.mutable_at(i, 2) = points.z_ref[k];
  }
  py::dict dict;
  dict["pixel"] = pixels;
  dict["p_camera"] = positions;
  dict["depth_sigma"] = py::array_t<float>(count, points.depth_sigma.data());
  return dict;
}

py::list keyframes_of(const vo::Tracker& tracker) {
  py::list keyframes;
  for (const auto& keyframe : tracker.map().keyframes()) {
    py::dict dict = points_dict(keyframe->points->levels.front());
    dict["timestamp"] = keyframe->pyramid.timestamp;
    dict["T_world_camera"] = matrix_of(keyframe->T_world_keyframe);
    keyframes.append(dict);
  }
  return keyframes;
}

template <typename T>
py::array_t<T> array_of(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Returns the inverse-depth map: one row of each array for each edge pixel of its host.
py::dict map_of(const PyMono& tracked) {
  const vo::DepthMap& map = tracked.odometry.map();
  const vo::Hypotheses& hypotheses = map.hypotheses();
  const auto count = static_cast<py::ssize_t>(hypotheses.size());
  py::array_t<int> pixels({count, py::ssize_t{2}});
  py::array_t<std::uint8_t> state(count);
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    pixels.mutable_at(i, 0) = hypotheses.pixel[k].x;
    pixels.mutable_at(i, 1) = hypotheses.pixel[k].y;
    state.mutable_at(i) = static_cast<std::uint8_t>(hypotheses.state[k]);
  }
  py::dict dict;
  dict["pixel"] = pixels;
  dict["inverse_depth"] = array_of(hypotheses.inverse_depth);
  dict["variance"] = array_of(hypotheses.variance);
  dict["smoothed"] = array_of(hypotheses.smoothed);
  dict["smoothed_variance"] = array_of(hypotheses.smoothed_variance);
  dict["state"] = state;
  dict["T_world_host"] = matrix_of(tracked.odometry.T_world_host());
  dict["timestamp"] = map.empty() ? 0 : map.host().timestamp;
  return dict;
}

/// Returns the times that the last frame's stages took.
py::dict times_dict(const vo::StageTimes& times) {
  py::dict dict;
  dict["pyramid_ms"] = times.pyramid_ms;
  dict["edges_ms"] = times.edges_ms;
  dict["alignment_ms"] = times.alignment_ms;
  dict["mapping_ms"] = times.mapping_ms;
  return dict;
}

void bind_options(py::module_& module) {
  py::class_<vo::TrackerOptions> tracker(module, "TrackerOptions",
                                         "Options of the RGB-D odometry, starting from a preset.");
  tracker.def(py::init(&tracker_options), py::arg("preset") = "default");
  bind_fields(tracker);
  py::class_<vo::MonoOptions> mono(module, "MonoOptions", "Options of the monocular odometry.");
  mono.def(py::init(&vo::mono_options));
  bind_fields(mono);
}

void bind_results(py::module_& module) {
  using Result = vo::TrackingResult;
  py::class_<Result>(module, "TrackingResult", "What is known of the camera after a frame.")
      .def_readonly("timestamp", &Result::timestamp, "s")
      .def_property_readonly(
          "status", [](const Result& r) { return std::string(vo::to_string(r.status)); },
          "initialized, tracked, uncertain or lost")
      .def_property_readonly(
          "reason", [](const Result& r) { return std::string(vo::to_string(r.reason)); },
          "why the frame is lost or uncertain, or none")
      .def_property_readonly(
          "T_world_camera", [](const Result& r) { return matrix_of(r.T_world_camera); },
          "4 x 4; the last tracked pose where the frame is lost")
      .def_readonly(
          "covariance", &Result::absolute_covariance,
          "6 x 6, of the increment [translation; rotation] right of T_world_camera, m and rad")
      .def_property_readonly(
          "relative_covariance", [](const Result& r) { return r.alignment.covariance; },
          "6 x 6, of the increment left of T_camera_reference")
      .def_readonly("reference_timestamp", &Result::reference_timestamp, "s")
      .def_readonly("is_keyframe", &Result::is_keyframe)
      .def_readonly("moving_fraction", &Result::moving_fraction,
                    "share of the view that moves by itself")
      .def_property_readonly(
          "points", [](const Result& r) { return r.alignment.points; },
          "points of the finest level that were aligned")
      .def_property_readonly("iterations", [](const Result& r) { return r.alignment.iterations; })
      .def_property_readonly(
          "correlation", [](const Result& r) { return r.alignment.correlation; },
          "of reference and current intensities")
      .def_property_readonly("visible_fraction",
                             [](const Result& r) { return r.alignment.visible_fraction; })
      .def_property_readonly(
          "readout_s", [](const Result& r) { return r.readout.seconds; },
          "rolling shutter's read-out time");
  py::class_<vo::MonoResult>(module, "MonoResult",
                             "What is known after a frame of a single camera.")
      .def_readonly("tracking", &vo::MonoResult::tracking)
      .def_property_readonly(
          "state", [](const vo::MonoResult& r) { return std::string(vo::to_string(r.state)); },
          "initialising, orienting, tracking, scale_uncertain, lost or reinitialising")
      .def_readonly("hypotheses", &vo::MonoResult::hypotheses, "edges of the map")
      .def_readonly("confident", &vo::MonoResult::confident, "edges whose depth is used");
}

}  // namespace

void bind_odometry(py::module_& module) {
  bind_options(module);
  bind_results(module);
  const auto frame_help = R"(Track a frame.

image: uint8, height x width grey or height x width x 3 blue, green, red, as OpenCV has it.
depth: float32 in metres or uint16 in the camera's units, height x width; None in mode mono.
depth_delay (RgbdOdometry): s, from the stamp of the image to that of the depth.
Arrays are not copied; they must not be written while the odometry is in use.)";
  const auto times_help = "wall-clock times of the last frame's stages, for diagnosis: dict of ms";
  py::class_<PyRgbd>(module, "RgbdOdometry", "RGB-D edge-direct odometry: one call per frame.")
      .def(py::init(&rgbd_odometry), py::arg("camera"), py::arg("options") = py::none(),
           py::arg("T_world_first") = py::none())
      .def("track", &track_rgbd, py::arg("timestamp"), py::arg("image"), py::arg("depth"),
           py::arg("depth_delay") = 0.0, frame_help)
      .def("track", &track_frame<vo::RgbdOdometry>, py::arg("frame"),
           "Track a frame of a Sequence, whose depth may have a stamp of its own.")
      .def_property_readonly(
          "trajectory", [](const PyRgbd& t) { return t.odometry.trajectory(); },
          "poses of the frames that are not lost")
      .def_property_readonly(
          "keyframes", [](const PyRgbd& t) { return keyframes_of(t.odometry.tracker()); },
          "the map: a dict of arrays for each keyframe")
      .def_property_readonly(
          "stage_times", [](const PyRgbd& t) { return times_dict(t.odometry.stage_times()); },
          times_help);
  py::class_<PyMono>(module, "MonoOdometry",
                     "Monocular edge-direct odometry with an inverse-depth map.")
      .def(py::init(&mono_odometry), py::arg("camera"), py::arg("options") = py::none(),
           py::arg("T_world_first") = py::none())
      .def("track", &track_mono, py::arg("timestamp"), py::arg("image"),
           py::arg("depth") = py::none(), frame_help)
      .def(
          "finish",
          [](PyMono& t) {
            const py::gil_scoped_release no_gil;
            return t.odometry.finish();
          },
          "End the sequence; a start that still waits for parallax is made with what there is.")
      .def_property_readonly(
          "trajectory", [](const PyMono& t) { return t.odometry.trajectory(); },
          "poses of the frames that are not lost")
      .def_property_readonly(
          "keyframes", [](const PyMono& t) { return keyframes_of(t.odometry.tracker()); },
          "the tracker's keyframes: a dict of arrays for each")
      .def_property_readonly(
          "stage_times", [](const PyMono& t) { return times_dict(t.odometry.stage_times()); },
          times_help)
      .def_property_readonly("map", &map_of, "the inverse-depth map: a dict of arrays");
}

}  // namespace python
