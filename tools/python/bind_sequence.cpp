#include <optional>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "tools/python/arrays.h"
#include "tools/python/bindings.h"
#include "vo/dataset/sequence.h"

namespace python {

namespace py = pybind11;

namespace {

vo::RgbdFrame read(const vo::SequenceReader& sequence, py::ssize_t index) {
  const auto size = static_cast<py::ssize_t>(sequence.size());
  if (index < -size || index >= size) {
    throw py::index_error("frame " + std::to_string(index) + " of " + std::to_string(size));
  }
  const py::gil_scoped_release no_gil;
  return sequence.read(static_cast<std::size_t>(index < 0 ? index + size : index));
}

/// Reads frames in their order, each while the one before is worked on.
struct FrameIterator {
  explicit FrameIterator(const vo::SequenceReader& sequence) : stream(sequence) {}

  vo::RgbdFrame next() {
    std::optional<vo::RgbdFrame> frame;
    {
      const py::gil_scoped_release no_gil;
      frame = stream.next();
    }
    if (!frame) {
      throw py::stop_iteration();
    }
    return *frame;
  }

  vo::FrameStream stream;
};

vo::SequenceReader open(const std::string& folder, const std::optional<vo::RgbdCamera>& camera,
                        double max_time_difference, bool with_depth) {
  const py::gil_scoped_release no_gil;
  return vo::SequenceReader(
      folder, camera, max_time_difference,
      with_depth ? vo::SequenceContent::colour_and_depth : vo::SequenceContent::colour);
}

}  // namespace

void bind_sequence(py::module_& module) {
  py::class_<vo::RgbdFrame>(module, "Frame", "One measurement of an RGB-D camera.")
      .def_readonly("timestamp", &vo::RgbdFrame::timestamp, "s, of the colour image")
      .def_property_readonly(
          "image", [](const vo::RgbdFrame& f) { return shared_array(f.image); },
          "uint8, grey or blue, green, red; read-only")
      .def_property_readonly(
          "depth", [](const vo::RgbdFrame& f) { return shared_array(f.depth); },
          "float32, m along the optical axis, 0 where there is none; read-only")
      .def_readonly("depth_delay", &vo::RgbdFrame::depth_delay,
                    "s, from the stamp of the image to that of the depth");
  py::class_<FrameIterator>(module, "FrameIterator")
      .def("__iter__", [](FrameIterator& frames) -> FrameIterator& { return frames; })
      .def("__next__", &FrameIterator::next);
  py::class_<vo::SequenceReader>(
      module, "Sequence", "A recorded sequence: TUM, EuRoC or ICL-NUIM, recognised by its files.")
      .def(py::init(&open), py::arg("folder"), py::arg("camera") = py::none(),
           py::arg("max_time_difference") = 0.02, py::arg("with_depth") = true)
      .def_property_readonly("camera", &vo::SequenceReader::camera)
      .def_property_readonly("ground_truth", &vo::SequenceReader::ground_truth,
                             "T_world_camera; empty where there is none")
      .def_property_readonly("timestamps",
                             [](const vo::SequenceReader& sequence) {
                               const auto stamps = sequence.timestamps();
                               return py::array_t<double>(static_cast<py::ssize_t>(stamps.size()),
                                                          stamps.data());
                             })
      .def("__len__", &vo::SequenceReader::size)
      .def("__getitem__", &read, py::arg("index"))
      .def(
          "__iter__", [](const vo::SequenceReader& s) { return FrameIterator(s); },
          py::keep_alive<0, 1>());
}

}  // namespace python
