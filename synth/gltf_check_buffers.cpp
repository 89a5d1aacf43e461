#include "synth/gltf_check_buffers.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// Bounds what an accessor without a buffer, which is all zeros, may ask for.
constexpr std::size_t kMostElements = std::size_t{1} << 26U;

std::size_t component_size(const JsonObject& object) {
  const std::size_t type = object.required_whole_number("componentType");
  switch (type) {
    case 5120:  // signed byte
    case 5121:  // unsigned byte
      return 1;
    case 5122:  // signed short
    case 5123:  // unsigned short
      return 2;
    case 5125:  // unsigned int
    case 5126:  // float
      return 4;
    default:
      vo::fail(object.place(), ": componentType is ", type,
               ", expected 5120, 5121, 5122, 5123, 5125 or 5126");
  }
}

struct Elements {
  std::size_t count = 0;
  std::size_t component_size = 0;  ///< bytes
  std::size_t size = 0;            ///< bytes of one element
  std::size_t packed_stride = 0;   ///< bytes from one element to the next without byteStride
};

/// The columns of matrices begin at multiples of four bytes; the last one is not padded.
Elements element_layout(const JsonObject& accessor, std::size_t count) {
  constexpr std::array<std::pair<const char*, std::size_t>, 4> kVectors = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};
  constexpr std::array<std::pair<const char*, std::size_t>, 3> kMatrices = {
      {{"MAT2", 2}, {"MAT3", 3}, {"MAT4", 4}}};
  const std::size_t component = component_size(accessor);
  const std::string type = accessor.required_text("type");
  for (const auto& [name, rows] : kVectors) {
    if (type == name) {
      return {count, component, rows * component, rows * component};
    }
  }
  for (const auto& [name, rows] : kMatrices) {
    if (type == name) {
      const std::size_t column = (rows * component + 3) / 4 * 4;
      return {count, component, (rows - 1) * column + rows * component, rows * column};
    }
  }
  vo::fail(accessor.place(), ": type is ", type, ", expected SCALAR, VEC2, ..., MAT4");
}

void check_view(const JsonObject& view, const std::vector<JsonObject>& buffers) {
  const std::size_t buffer = view.required_index("buffer", buffers.size());
  const std::size_t available = buffers[buffer].required_whole_number("byteLength");
  const std::size_t offset = view.whole_number("byteOffset").value_or(0);
  const std::size_t length = view.required_whole_number("byteLength");
  require(offset <= available && length <= available - offset, view.place(), ": spans ", length,
          " bytes from byte ", offset, ", expected at most the ", available, " bytes of buffers[",
          buffer, ']');
  const std::size_t stride = view.whole_number("byteStride").value_or(4);
  require(stride >= 4 && stride <= 252 && stride % 4 == 0, view.place(), ": byteStride is ", stride,
          ", expected a multiple of 4 from 4 to 252");
}

/// The elements must lie in the view that `object`, which refers to them, names.
void check_range(const JsonObject& object, const Elements& elements,
                 const std::vector<JsonObject>& views) {
  const auto [count, component, size, packed_stride] = elements;
  const JsonObject& view = views[object.required_index("bufferView", views.size())];
  const std::size_t offset = object.whole_number("byteOffset").value_or(0);
  const std::size_t stride = view.whole_number("byteStride").value_or(packed_stride);
  const std::size_t length = view.required_whole_number("byteLength");
  require(stride >= size, object.place(), ": elements have ", size,
          " bytes, expected at most the byteStride ", stride, " of its bufferView");
  require(
      offset <= length && size <= length - offset && count - 1 <= (length - offset - size) / stride,
      object.place(), ": ", count, " elements of ", size, " bytes from byte ", offset,
      " do not fit, expected at most the ", length, " bytes of its bufferView");
  const std::size_t begin = view.whole_number("byteOffset").value_or(0) + offset;
  require(offset % component == 0 && begin % component == 0 && stride % component == 0,
          object.place(), ": its elements are not aligned, expected multiples of ", component,
          " bytes");
}

void check_sparse(const JsonObject& sparse, const Elements& accessor,
                  const std::vector<JsonObject>& views) {
  const std::size_t count = sparse.required_whole_number("count");
  require(count > 0 && count <= accessor.count, sparse.place(), ": count is ", count,
          ", expected 1 to ", accessor.count);
  const JsonObject indices = sparse.required_object("indices");
  const std::size_t index_size = component_size(indices);
  require(is_unsigned_component(indices.required_whole_number("componentType")), indices.place(),
          ": componentType is signed, expected an unsigned integer");
  check_range(indices, {count, index_size, index_size, index_size}, views);
  Elements values = accessor;
  values.count = count;
  check_range(sparse.required_object("values"), values, views);
}

void check_accessor(const JsonObject& accessor, const std::vector<JsonObject>& views) {
  const std::size_t count = accessor.required_whole_number("count");
  require(count > 0 && count <= kMostElements, accessor.place(), ": count is ", count,
          ", expected 1 to ", kMostElements);
  const Elements elements = element_layout(accessor, count);
  if (accessor.has("bufferView")) {
    check_range(accessor, elements, views);
  }
  if (const auto sparse = accessor.object("sparse")) {
    check_sparse(*sparse, elements, views);
  }
}

}  // namespace

bool is_unsigned_component(std::size_t component_type) {
  return component_type == 5121 || component_type == 5123 || component_type == 5125;
}

void check_buffers(const JsonObject& root) {
  const std::vector<JsonObject> buffers = root.objects("buffers");
  const std::vector<JsonObject> views = root.objects("bufferViews");
  for (const JsonObject& buffer : buffers) {
    require(buffer.required_whole_number("byteLength") > 0, buffer.place(),
            ": byteLength is 0, expected at least 1");
  }
  for (const JsonObject& view : views) {
    check_view(view, buffers);
  }
  for (const JsonObject& accessor : root.objects("accessors")) {
    check_accessor(accessor, views);
  }
}

}  // namespace synth
