#include "synth/gltf_meshopt.h"

#include <algorithm>
#include <string>
#include <vector>

#include <meshoptimizer.h>

#include "synth/gltf_reading.h"
#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

constexpr const char* kName = "EXT_meshopt_compression";

/// The extension's object of a buffer view.
struct Compressed {
  std::size_t buffer = 0;
  std::size_t offset = 0;
  std::size_t length = 0;
  std::size_t stride = 0;  ///< bytes
  std::size_t count = 0;
  std::string mode, filter;
};

Compressed read_compressed(const JsonObject& extension) {
  return {.buffer = extension.required_whole_number("buffer"),
          .offset = extension.whole_number("byteOffset").value_or(0),
          .length = extension.required_whole_number("byteLength"),
          .stride = extension.required_whole_number("byteStride"),
          .count = extension.required_whole_number("count"),
          .mode = extension.required_text("mode"),
          .filter = extension.text("filter").value_or("NONE")};
}

bool is_stride_of_mode(const Compressed& view) {
  return view.mode == "ATTRIBUTES" ? view.stride % 4 == 0 && view.stride >= 4 && view.stride <= 256
                                   : view.stride == 2 || view.stride == 4;
}

bool is_filter_for(const Compressed& view) {
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
  const Compressed view = read_compressed(extension);
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

/// 0 if it could be decoded.
int decode(const Compressed& view, const std::uint8_t* data, Bytes& decoded) {
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(decoded.data(), view.count, view.stride, data, view.length);
  }
  return view.mode == "TRIANGLES"
             ? meshopt_decodeIndexBuffer(decoded.data(), view.count, view.stride, data, view.length)
             : meshopt_decodeIndexSequence(decoded.data(), view.count, view.stride, data,
                                           view.length);
}

void apply_filter(const Compressed& view, Bytes& decoded) {
  if (view.filter == "OCTAHEDRAL") {
    meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
  } else if (view.filter == "QUATERNION") {
    meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
  } else if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
  }
}

}  // namespace

void check_meshopt(const JsonObject& root) {
  const std::vector<JsonObject> buffers = root.objects("buffers");
  for (const JsonObject& view : root.objects("bufferViews")) {
    const auto extension = view.extension(kName);
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
  const auto extension = buffer.extension(kName);
  return extension && extension->flag("fallback").value_or(false);
}

void decode_meshopt(const JsonObject& root, GltfModel& model) {
  MemoryBudget budget;
  const std::vector<JsonObject> views = root.objects("bufferViews");
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto extension = views[i].extension(kName);
    if (!extension) {
      continue;
    }
    const Compressed view = read_compressed(*extension);
    const Bytes& source = model.content.buffers[view.buffer].data;
    require(view.offset + view.length <= source.size(), extension->place(),
            ": refers to a buffer without data, expected compressed data");
    budget.take(view.count * view.stride, views[i].place());
    tinygltf::Buffer decoded;
    decoded.data.resize(view.count * view.stride);
    require(decode(view, source.data() + view.offset, decoded.data) == 0, extension->place(),
            ": cannot be decoded, expected undamaged data of EXT_meshopt_compression");
    apply_filter(view, decoded.data);
    model.content.bufferViews[i].buffer = static_cast<int>(model.content.buffers.size());
    model.content.bufferViews[i].byteOffset = 0;
    model.content.buffers.push_back(std::move(decoded));
  }
}

}  // namespace synth
