#pragma once

#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "vo/core/fields.h"
#include "vo/text_files/toml_file.h"

namespace python {

/// Returns the value of a field as Python has it: bool, int, float, str, or a list of floats.
pybind11::object value_of(const vo::Field& field);

/// Returns the text of a Python value from which a field of that type is set. Throws vo::Error
/// naming the key for a value that no option has.
std::string text_of(const std::string& key, const pybind11::handle& value);

/// Sets fields from a dict whose values are values or dicts of the keys' continuations:
/// {"align.max_iterations": 20} is {"align": {"max_iterations": 20}}.
void assign_dict(std::vector<vo::Field>& fields, const pybind11::dict& values,
                 const std::string& prefix = "");

/// Gives a class of options, whose fields `visit_fields` lists, what all classes of options have in
/// Python: keys(), get(key), set(key, value), help(key), update(dict), to_dict(), to_toml() and
/// from_toml(path). Attributes follow from these in edvo/_options.py.
template <typename Options>
void bind_fields(pybind11::class_<Options>& bound) {
  namespace py = pybind11;
  const auto find = [](Options& options, const std::string& key) {
    auto fields = vo::fields_of(options);
    return vo::find_field(fields, key);
  };
  bound.def(
      "keys",
      [](Options& options) {
        std::vector<std::string> keys;
        for (const vo::Field& field : vo::fields_of(options)) {
          keys.push_back(field.key);
        }
        return keys;
      },
      "Return the dotted keys of all options.");
  bound.def(
      "get",
      [find](Options& options, const std::string& key) { return value_of(find(options, key)); },
      py::arg("key"), "Return the value of a dotted key.");
  bound.def(
      "help", [find](Options& options, const std::string& key) { return find(options, key).help; },
      py::arg("key"), "Return the meaning and unit of a dotted key.");
  bound.def(
      "set",
      [](Options& options, const std::string& key, const py::object& value) {
        auto fields = vo::fields_of(options);
        vo::set_field(fields, key, text_of(key, value));
      },
      py::arg("key"), py::arg("value"), "Set the value of a dotted key.");
  bound.def(
      "update",
      [](Options& options, const py::dict& values) {
        auto fields = vo::fields_of(options);
        assign_dict(fields, values);
      },
      py::arg("values"), "Set options from a dict with dotted keys or dicts in it.");
  bound.def(
      "to_dict",
      [](Options& options) {
        py::dict values;
        for (const vo::Field& field : vo::fields_of(options)) {
          values[py::str(field.key)] = value_of(field);
        }
        return values;
      },
      "Return all values by their dotted keys.");
  bound.def(
      "to_toml", [](Options& options) { return vo::format_toml(vo::fields_of(options)); },
      "Return the options as TOML, from which from_toml reads equal ones.");
  bound.def(
      "update_from_toml",
      [](Options& options, const std::string& path) {
        auto fields = vo::fields_of(options);
        vo::assign_fields(vo::read_toml(path), fields);
      },
      py::arg("path"), "Set the options that a TOML file names.");
  bound.def("__copy__", [](const Options& options) { return Options(options); });
  bound.def("__deepcopy__",
            [](const Options& options, const py::dict&) { return Options(options); });
}

}  // namespace python
