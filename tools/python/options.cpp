#include "tools/python/options.h"

#include "vo/core/error.h"

namespace python {

namespace py = pybind11;

namespace {

/// Returns the numbers of a text that has commas between them.
py::list list_of_reals(const std::string& text) {
  py::list numbers;
  for (const py::handle part : py::str(text).attr("split")(",")) {
    numbers.append(vo::parse_real(py::cast<std::string>(part)));
  }
  return numbers;
}

}  // namespace

py::object value_of(const vo::Field& field) {
  const std::string text = field.get();
  switch (field.type) {
    case vo::FieldType::boolean:
      return py::bool_(vo::parse_boolean(text));
    case vo::FieldType::integer:
      return py::int_(vo::parse_integer(text));
    case vo::FieldType::real:
      return py::float_(vo::parse_real(text));
    case vo::FieldType::reals:
      return list_of_reals(text);
    default:
      return py::str(text);
  }
}

std::string text_of(const std::string& key, const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) {
    return py::cast<bool>(value) ? "true" : "false";
  }
  if (py::isinstance<py::str>(value)) {
    return py::cast<std::string>(value);
  }
  if (PyIndex_Check(value.ptr()) != 0) {
    return py::cast<std::string>(
        py::str(py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()))));
  }
  if (PyNumber_Check(value.ptr()) != 0 && !py::isinstance<py::sequence>(value)) {
    return vo::format_real(py::cast<double>(py::float_(py::reinterpret_borrow<py::object>(value))));
  }
  vo::require(py::isinstance<py::iterable>(value), key, ": is a ",
              py::cast<std::string>(py::str(py::type::handle_of(value).attr("__name__"))),
              ", expected a number, a text or a list of numbers");
  std::string text;
  for (const py::handle element : value) {
    text += (text.empty() ? "" : ",") + text_of(key, element);
  }
  return text;
}

void assign_dict(std::vector<vo::Field>& fields, const py::dict& values,
                 const std::string& prefix) {
  for (const auto& [name, value] : values) {
    const std::string key = prefix + py::cast<std::string>(py::str(name));
    if (py::isinstance<py::dict>(value)) {
      assign_dict(fields, py::reinterpret_borrow<py::dict>(value), key + ".");
    } else {
      vo::set_field(fields, key, text_of(key, value));
    }
  }
}

}  // namespace python
