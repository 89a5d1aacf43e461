#include <exception>

#include <pybind11/pybind11.h>

#include "tools/python/bindings.h"
#include "vo/core/error.h"
#include "vo/core/version.h"

namespace py = pybind11;

namespace {

/// Makes edvo.Error, whose `kind` is the name of the error's kind, of each vo::Error.
void bind_errors(py::module_& module) {
  static PyObject* error = nullptr;
  error = PyErr_NewExceptionWithDoc("edvo.Error",
                                    "What cannot be done, in one sentence; `kind` says why.",
                                    PyExc_RuntimeError, nullptr);
  module.attr("Error") = py::reinterpret_borrow<py::object>(error);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) {
        std::rethrow_exception(thrown);
      }
    } catch (const vo::Error& caught) {
      const py::object value = py::reinterpret_borrow<py::object>(error)(caught.what());
      value.attr("kind") = std::string(vo::to_string(caught.kind()));
      PyErr_SetObject(error, value.ptr());
    }
  });
}

}  // namespace

PYBIND11_MODULE(_edvo, module) {
  module.doc() = "Edge-direct visual odometry and its synthetic RGB-D laboratory.";
  module.attr("__version__") = vo::version();
  bind_errors(module);
  python::bind_geometry(module);
  python::bind_evaluation(module);
  python::bind_odometry(module);
  python::bind_sequence(module);
  python::bind_rendering(module);
}
