#include <string>

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "tools/python/arrays.h"
#include "tools/python/bindings.h"
#include "tools/python/options.h"
#include "vo/core/error.h"
#include "vo/dataset/camera_file.h"
#include "vo/files/output.h"
#include "vo/geometry/camera.h"
#include "vo/geometry/trajectory.h"
#include "vo/motion_files/trajectory_file.h"

namespace python {

namespace py = pybind11;

namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

vo::Trajectory trajectory_of(const Doubles& timestamps, const Doubles& poses) {
  vo::require(timestamps.ndim() == 1 && poses.ndim() == 3 && poses.shape(0) == timestamps.size() &&
                  poses.shape(1) == 4 && poses.shape(2) == 4,
              "trajectory: expected N timestamps and N x 4 x 4 poses");
  vo::Trajectory trajectory;
  for (py::ssize_t i = 0; i < timestamps.size(); ++i) {
    vo::require(i == 0 || timestamps.at(i) > timestamps.at(i - 1), "trajectory: timestamp ", i,
                " does not increase");
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        matrix(row, column) = poses.at(i, row, column);
      }
    }
    trajectory.push_back({timestamps.at(i), motion_of(matrix)});
  }
  return trajectory;
}

Doubles timestamps_of(const vo::Trajectory& trajectory) {
  Doubles values(static_cast<py::ssize_t>(trajectory.size()));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    values.mutable_at(i) = trajectory[i].timestamp;
  }
  return values;
}

Doubles positions_of(const vo::Trajectory& trajectory) {
  Doubles values({static_cast<py::ssize_t>(trajectory.size()), py::ssize_t{3}});
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      values.mutable_at(i, k) = trajectory[i].T_world_camera.translation()[k];
    }
  }
  return values;
}

Doubles quaternions_of(const vo::Trajectory& trajectory) {
  Doubles values({static_cast<py::ssize_t>(trajectory.size()), py::ssize_t{4}});
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      values.mutable_at(i, k) = trajectory[i].T_world_camera.rotation().coeffs()[k];
    }
  }
  return values;
}

Doubles poses_of(const vo::Trajectory& trajectory) {
  Doubles values({static_cast<py::ssize_t>(trajectory.size()), py::ssize_t{4}, py::ssize_t{4}});
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Eigen::Matrix4d matrix = matrix_of(trajectory[i].T_world_camera);
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        values.mutable_at(i, row, column) = matrix(row, column);
      }
    }
  }
  return values;
}

void write_trajectory(const vo::Trajectory& trajectory, const std::string& path, bool replace) {
  vo::write_file(path, vo::format_trajectory(trajectory),
                 replace ? vo::ExistingOutput::replace : vo::ExistingOutput::keep);
}

void bind_camera(py::module_& module) {
  py::class_<vo::RgbdCamera> camera(
      module, "Camera",
      "A pinhole camera with lens distortion and a depth image registered to it. Frame: x right, "
      "y\n"
      "down, z forward; pixel (0, 0) is the centre of the top-left pixel.");
  camera.def(py::init([] { return vo::RgbdCamera{}; }));
  bind_fields(camera);
  camera.def("validate", &vo::RgbdCamera::validate, "Raise Error unless the values are usable.");
  module.def("load_camera", &vo::load_camera, py::arg("preset_or_path"),
             "Return the camera of a public data set by name, or of a camera.toml.");
}

void bind_trajectory(py::module_& module) {
  py::class_<vo::Trajectory>(module, "Trajectory",
                             "Poses T_world_camera in increasing time, metres and seconds.")
      .def(py::init(&trajectory_of), py::arg("timestamps"), py::arg("poses"))
      .def("__len__", [](const vo::Trajectory& trajectory) { return trajectory.size(); })
      .def_property_readonly("timestamps", &timestamps_of, "s, N")
      .def_property_readonly("positions", &positions_of, "m, N x 3")
      .def_property_readonly("quaternions", &quaternions_of, "N x 4, in the order x, y, z, w")
      .def_property_readonly("poses", &poses_of, "T_world_camera, N x 4 x 4")
      .def("to_tum", &vo::format_trajectory, "Return the text of a file in TUM's format.")
      .def("write", &write_trajectory, py::arg("path"), py::arg("replace") = false,
           "Write a file in TUM's format, which appears when it is complete.");
  module.def(
      "read_trajectory", [](const std::string& path) { return vo::read_trajectory(path); },
      py::arg("path"),
      "Read a trajectory in any format that edvo reads, recognised by its content.");
}

}  // namespace

void bind_geometry(py::module_& module) {
  bind_camera(module);
  bind_trajectory(module);
}

}  // namespace python
