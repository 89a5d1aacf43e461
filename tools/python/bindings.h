#pragma once

#include <pybind11/pybind11.h>

#include "vo/geometry/trajectory.h"

// A trajectory is a class of its own in Python, not a list.
PYBIND11_MAKE_OPAQUE(vo::Trajectory)

namespace python {

// Each binds one part of the library into the module.
void bind_geometry(pybind11::module_& module);    ///< Camera, Trajectory
void bind_evaluation(pybind11::module_& module);  ///< evaluate
void bind_odometry(pybind11::module_& module);    ///< options, results, RgbdOdometry, MonoOdometry
void bind_sequence(pybind11::module_& module);    ///< Frame, Sequence
void bind_rendering(pybind11::module_& module);   ///< Scene, Renderer

}  // namespace python
