#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "tools/python/bindings.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/evaluation/evaluate.h"

namespace python {

namespace py = pybind11;

namespace {

/// An evaluation with the error of each pose beside the statistics.
struct Evaluation {
  vo::TrajectoryErrors errors;
  vo::Trajectory aligned;
  vo::ErrorsOverTime over_time;
};

Evaluation evaluated(const vo::Trajectory& truth, const vo::Trajectory& estimate,
                     const std::string& align, double interval, double max_time_difference,
                     double time_offset) {
  vo::EvaluationOptions options;
  options.alignment = vo::parse_enum<vo::TrajectoryAlignment>(align);
  options.interval.length = interval;
  options.max_time_difference = max_time_difference;
  options.time_offset = time_offset;
  const py::gil_scoped_release no_gil;
  return {vo::evaluate(truth, estimate, options),
          vo::align_trajectory(truth, estimate, options).value(),
          vo::errors_over_time(truth, estimate, options)};
}

py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace

void bind_evaluation(py::module_& module) {
  py::class_<vo::Statistics>(module, "Statistics", "Root mean square, mean, median and maximum.")
      .def_readonly("rmse", &vo::Statistics::rmse)
      .def_readonly("mean", &vo::Statistics::mean)
      .def_readonly("median", &vo::Statistics::median)
      .def_readonly("max", &vo::Statistics::max);
  py::class_<Evaluation>(module, "Evaluation",
                         "Errors of an estimated trajectory against the truth.")
      .def_property_readonly(
          "ate", [](const Evaluation& e) { return e.errors.ate; },
          "absolute error of the positions after alignment, m")
      .def_property_readonly(
          "rpe_translation", [](const Evaluation& e) { return e.errors.rpe.translation; },
          "relative error over the interval, m")
      .def_property_readonly(
          "rpe_rotation_deg", [](const Evaluation& e) { return e.errors.rpe.rotation_deg; },
          "relative error over the interval, deg")
      .def_property_readonly(
          "scale", [](const Evaluation& e) { return e.errors.scale; },
          "factor from estimate to truth, 1 unless align is sim3")
      .def_property_readonly(
          "matched", [](const Evaluation& e) { return e.errors.matched; },
          "poses of the estimate that have a partner in the truth")
      .def_readonly("aligned", &Evaluation::aligned, "the estimate moved onto the truth")
      .def_property_readonly(
          "timestamps", [](const Evaluation& e) { return array_of(e.over_time.timestamps); },
          "stamps of the matched poses, s")
      .def_property_readonly(
          "ate_over_time", [](const Evaluation& e) { return array_of(e.over_time.ate); },
          "absolute error of each matched pose, m")
      .def_property_readonly(
          "rpe_timestamps",
          [](const Evaluation& e) { return array_of(e.over_time.rpe_timestamps); },
          "stamps of the beginnings of the intervals, s")
      .def_property_readonly(
          "rpe_translation_over_time",
          [](const Evaluation& e) { return array_of(e.over_time.rpe_translation); },
          "relative error of each interval, m")
      .def_property_readonly(
          "rpe_rotation_deg_over_time",
          [](const Evaluation& e) { return array_of(e.over_time.rpe_rotation_deg); },
          "relative error of each interval, deg");
  module.def(
      "evaluate", &evaluated, py::arg("truth"), py::arg("estimate"), py::arg("align") = "se3",
      py::arg("interval") = 1.0, py::arg("max_time_difference") = 0.02,
      py::arg("time_offset") = 0.0,
      "Return the errors of an estimate: ATE after alignment (none, se3, sim3), RPE over an\n"
      "interval in seconds, as the TUM benchmark defines them.");
}

}  // namespace python
