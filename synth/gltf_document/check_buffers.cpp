#include "synth/gltf_document/check_buffers.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "vo/core/error.h"

namespace synth {
namespace {

using vo::require;

/// The limit of an accessor's count, as no buffer bounds an accessor that has no buffer view.
constexpr std::size_t kMostElements = std::size_t{1} << 26U;

/// Returns the bytes of the object's componentType; nothing for one that is not in glTF 2.0.
std::optional<std::size_t> component_size(const JsonObject& object) {
  switch (object.required_whole_number("componentType")) {
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
      return std::nullopt;
  }
}

struct Elements {
  std::size_t count = 0;
  std::size_t components = 0;      ///< components of one element
  std::size_t component_size = 0;  ///< bytes of one component
  std::size_t alignment = 0;       ///< bytes, divisor of the accessor's byteOffset
  std::size_t size = 0;            ///< bytes of one element
  std::size_t packed_stride = 0;   ///< bytes from one element to the next without byteStride
};

/// Returns an accessor's memory layout; nothing for types not in glTF 2.0, which unused accessors
/// may have. Matrix columns begin at multiples of four bytes; the last one is not padded.
std::optional<Elements> element_layout(const JsonObject& accessor, std::size_t count) {
  constexpr std::array<std::pair<const char*, std::size_t>, 4> kVectors = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};
  constexpr std::array<std::pair<const char*, std::size_t>, 3> kMatrices = {
      {{"MAT2", 2}, {"MAT3", 3}, {"MAT4", 4}}};
  const std::optional<std::size_t> component = component_size(accessor);
  const std::string type = accessor.required_text("type");
  for (const auto& [name, rows] : kVectors) {
    if (component && type == name) {
      return Elements{count, rows, *component, *component, rows * *component, rows * *component};
    }
  }
  for (const auto& [name, rows] : kMatrices) {
    if (component && type == name) {
      const std::size_t column = (rows * *component + 3) / 4 * 4;
      return Elements{
          count,        rows * rows, *component, 4, (rows - 1) * column + rows * *component,
          rows * column};
    }
  }
  return std::nullopt;
}

void check_view(const JsonObject& view, const std::vector<JsonObject>& buffers) {
  const std::size_t buffer = view.required_index("buffer", buffers.size());
  const std::size_t available = buffers[buffer].required_whole_number("byteLength");
  const std::size_t offset = view.whole_number("byteOffset").value_or(0);
  const std::size_t length = view.required_whole_number("byteLength");
  require(offset <= available && length <= available - offset, view.place(), ": spans ", length,
          " bytes from byte ", offset, ", expected at most the ", available, " bytes of buffers[",
          buffer, ']');
  require(length > 0, view.place(), ": byteLength is 0, expected at least 1");
}

/// Returns what glTF allows instead of a buffer view's byteStride (3.6.2.4 and 5.11.4); empty for a
/// stride that it allows and for a view without one.
std::string expected_stride(const JsonObject& view) {
  constexpr std::size_t kElementArray = 34963;  // OpenGL's ELEMENT_ARRAY_BUFFER
  const std::optional<std::size_t> stride = view.whole_number("byteStride");
  if (!stride) {
    return {};
  }
  if (*stride < 4 || *stride > 252 || *stride % 4 != 0) {
    return "a multiple of 4 from 4 to 252";
  }
  const std::size_t length = view.required_whole_number("byteLength");
  if (*stride > length) {
    return "at most its byteLength " + std::to_string(length);
  }
  return view.whole_number("target") == kElementArray ? "none in a view for indices" : "";
}

/// Returns whether elements are read the same whether their view's byteStride is followed or not.
bool is_needless_stride(std::size_t stride, std::size_t count, std::size_t packed_stride) {
  return count == 1 || stride == packed_stride;
}

void note_needless_stride(Notes& notes) {
  add_note(notes, "byteStrides where glTF allows none, but which change nothing, are ignored");
}

/// Checks that elements lie in the buffer view that `object` refers to, and are aligned.
void check_range(const JsonObject& object, const Elements& elements,
                 const std::vector<JsonObject>& views) {
  const auto [count, components, component, alignment, size, packed_stride] = elements;
  const JsonObject& view = views[object.required_index("bufferView", views.size())];
  const std::size_t offset = object.whole_number("byteOffset").value_or(0);
  const std::size_t stride = view.whole_number("byteStride").value_or(packed_stride);
  const std::size_t length = view.required_whole_number("byteLength");
  const std::string expected = expected_stride(view);
  require(expected.empty() || is_needless_stride(stride, count, packed_stride), view.place(),
          ": byteStride is ", stride, ", expected ", expected, ", or the ", packed_stride,
          " bytes of the elements of ", object.place());
  require(stride >= size, object.place(), ": elements have ", size,
          " bytes, expected at most the byteStride ", stride, " of its bufferView");
  require(
      offset <= length && size <= length - offset && count - 1 <= (length - offset - size) / stride,
      object.place(), ": ", count, " elements of ", size, " bytes from byte ", offset,
      " do not fit, expected at most the ", length, " bytes of its bufferView");
  const std::size_t begin = view.whole_number("byteOffset").value_or(0) + offset;
  require(offset % alignment == 0 && begin % component == 0 && stride % component == 0,
          object.place(), ": its elements are not aligned, expected multiples of ", component,
          " bytes, and a byteOffset that is one of ", alignment);
}

void check_sparse(const JsonObject& sparse, const Elements& accessor,
                  const std::vector<JsonObject>& views) {
  const std::size_t count = sparse.required_whole_number("count");
  require(count > 0 && count <= accessor.count, sparse.place(), ": count is ", count,
          ", expected 1 to ", accessor.count);
  const JsonObject indices = sparse.required_object("indices");
  const std::size_t type = indices.required_whole_number("componentType");
  require(is_unsigned_component(type), indices.place(), ": componentType is ", type,
          ", expected an unsigned integer, 5121, 5123 or 5125");
  const std::size_t size = component_size(indices).value_or(0);
  check_range(indices, {count, 1, size, size, size, size}, views);
  Elements values = accessor;
  values.count = count;
  check_range(sparse.required_object("values"), values, views);
}

void check_accessor(const JsonObject& accessor, const std::vector<JsonObject>& views) {
  const std::size_t count = accessor.required_whole_number("count");
  require(count > 0 && count <= kMostElements, accessor.place(), ": count is ", count,
          ", expected 1 to ", kMostElements);
  accessor.index("bufferView", views.size());
  require(!accessor.has("byteOffset") || accessor.has("bufferView"), accessor.place(),
          ": has a byteOffset without bufferView, expected both");
  const std::optional<Elements> elements = element_layout(accessor, count);
  if (!elements) {
    return;
  }
  accessor.numbers("min", elements->components);
  accessor.numbers("max", elements->components);
  if (accessor.has("bufferView")) {
    check_range(accessor, *elements, views);
  }
  if (const auto sparse = accessor.object("sparse")) {
    check_sparse(*sparse, *elements, views);
  }
}

}  // namespace

bool is_unsigned_component(std::size_t component_type) {
  return component_type == 5121 || component_type == 5123 || component_type == 5125;
}

std::optional<std::size_t> packed_stride(const JsonObject& accessor) {
  const std::optional<Elements> elements = element_layout(accessor, 1);
  return elements ? std::optional(elements->packed_stride) : std::nullopt;
}

void require_element_type(const JsonObject& accessor, const std::string& type,
                          const std::string& place) {
  const std::string found = accessor.required_text("type");
  require(found == type, place, ": is of type ", found, ", expected ", type);
}

void require_float_components(const JsonObject& accessor, const std::string& place) {
  const std::size_t component = accessor.required_whole_number("componentType");
  require(component == 5126, place, ": has components of type ", component, ", expected float");
}

void require_packed(const JsonObject& accessor, const std::vector<JsonObject>& views,
                    const std::string& place, Notes& notes) {
  const std::optional<std::size_t> view = accessor.index("bufferView", views.size());
  const std::optional<std::size_t> stride =
      view ? views[*view].whole_number("byteStride") : std::nullopt;
  const std::optional<std::size_t> packed = packed_stride(accessor);
  if (!stride || !packed) {
    return;
  }
  require(is_needless_stride(*stride, accessor.required_whole_number("count"), *packed), place,
          ": is in a bufferView with byteStride ", *stride, ", expected none or the ", *packed,
          " bytes of an element");
  note_needless_stride(notes);
}

void check_buffers(const JsonObject& root, Notes& notes) {
  const std::vector<JsonObject> buffers = root.objects("buffers");
  const std::vector<JsonObject> views = root.objects("bufferViews");
  for (const JsonObject& buffer : buffers) {
    require(buffer.required_whole_number("byteLength") > 0, buffer.place(),
            ": byteLength is 0, expected at least 1");
  }
  for (const JsonObject& view : views) {
    check_view(view, buffers);
    if (!expected_stride(view).empty()) {
      note_needless_stride(notes);
    }
  }
  for (const JsonObject& accessor : root.objects("accessors")) {
    check_accessor(accessor, views);
  }
  for (const JsonObject& image : root.objects("images")) {
    const std::optional<std::size_t> view = image.index("bufferView", views.size());
    if (view && views[*view].has("byteStride")) {  // an image's bytes are no elements
      note_needless_stride(notes);
    }
  }
}

}  // namespace synth
