#include "synth/gltf_document/check_meshopt.h"

#include <vector>

#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

bool is_stride_of_mode(const MeshoptView& view) {
  return view.mode == "ATTRIBUTES" ? view.stride % 4 == 0 && view.stride >= 4 && view.stride <= 256
                                   : view.stride == 2 || view.stride == 4;
}

bool is_filter_for(const MeshoptView& view) {
  if (view.filter == "NONE") {
    return true;
  }
  return view.mode == "ATTRIBUTES" &&
         ((view.filter == "OCTAHEDRAL" && (view.stride == 4 || view.stride == 8)) ||
          (view.filter == "QUATERNION" && view.stride == 8) || view.filter == "EXPONENTIAL");
}

void check_compressed(const JsonObject& object, const JsonObject& extension,
                      const std::vector<JsonObject>& buffers) {
  extension.required_index("buffer", buffers.size());
  const MeshoptView view = read_meshopt_view(extension);
  const std::size_t available = buffers[view.buffer].required_whole_number("byteLength");
  require(view.offset <= available && view.length <= available - view.offset, extension.place(),
          ": spans ", view.length, " bytes from byte ", view.offset, ", expected at most the ",
          available, " bytes of buffers[", view.buffer, ']');
  require(view.mode == "ATTRIBUTES" || view.mode == "TRIANGLES" || view.mode == "INDICES",
          extension.place(), ": mode is ", view.mode,
          ", expected ATTRIBUTES, TRIANGLES or INDICES");
  require(is_stride_of_mode(view), extension.place(), ": byteStride is ", view.stride,
          ", expected a multiple of 4 up to 256 for attributes, 2 or 4 for indices");
  require(is_filter_for(view), extension.place(), ": filter ", view.filter,
          " does not go with its mode and byteStride, expected NONE or one that does");
  const std::size_t length = object.required_whole_number("byteLength");
  require(view.count > 0 && view.count <= length && view.count * view.stride == length,
          extension.place(), ": decodes to ", view.count, " elements of ", view.stride,
          " bytes, expected the ", length, " bytes of its bufferView");
  require(view.mode != "TRIANGLES" || view.count % 3 == 0, extension.place(), ": count is ",
          view.count, ", expected three for each triangle");
}

}  // namespace

MeshoptView read_meshopt_view(const JsonObject& extension) {
  return {.buffer = extension.required_whole_number("buffer"),
          .offset = extension.whole_number("byteOffset").value_or(0),
          .length = extension.required_whole_number("byteLength"),
          .stride = extension.required_whole_number("byteStride"),
          .count = extension.required_whole_number("count"),
          .mode = extension.required_text("mode"),
          .filter = extension.text("filter").value_or("NONE")};
}

void check_meshopt(const JsonObject& root) {
  const std::vector<JsonObject> buffers = root.objects("buffers");
  for (const JsonObject& view : root.objects("bufferViews")) {
    const auto extension = view.extension(kMeshoptExtension);
    if (extension) {
      check_compressed(view, *extension, buffers);
      continue;
    }
    const JsonObject& buffer = buffers[view.required_index("buffer", buffers.size())];
    require(buffer.has("uri") || !is_meshopt_fallback(buffer), view.place(), ": refers to ",
            buffer.place(), ", a fallback without data, expected compressed data");
  }
}

bool is_meshopt_fallback(const JsonObject& buffer) {
  const auto extension = buffer.extension(kMeshoptExtension);
  return extension && extension->flag("fallback").value_or(false);
}

}  // namespace synth
