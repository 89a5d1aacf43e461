#include "synth/gltf_model/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "vo/core/error.h"

namespace synth {
namespace {

/// Elements in a buffer: `count` times `components` values, `stride` bytes from one element to the
/// next.
struct ElementArray {
  const std::uint8_t* data = nullptr;
  std::size_t count = 0;
  std::size_t components = 0;
  std::size_t stride = 0;
  int component_type = 0;
  bool normalized = false;
};

template <typename Out, typename Component>
Out convert(Component value, bool normalized) {
  if constexpr (std::is_floating_point_v<Out> && std::is_integral_v<Component>) {
    if (normalized) {
      constexpr auto kOne = static_cast<Out>(std::numeric_limits<Component>::max());
      return std::max(static_cast<Out>(value) / kOne, Out{-1});
    }
  }
  return static_cast<Out>(value);
}

template <typename Component, typename Out>
void copy_elements(const ElementArray& source, Out* out) {
  for (std::size_t i = 0; i < source.count; ++i) {
    const std::uint8_t* element = source.data + i * source.stride;
    for (std::size_t c = 0; c < source.components; ++c) {
      Component value;
      std::memcpy(&value, element + c * sizeof(Component), sizeof(Component));
      *out++ = convert<Out>(value, source.normalized);
    }
  }
}

template <typename Out>
void read_elements(const ElementArray& source, Out* out) {
  switch (source.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copy_elements<std::int8_t>(source, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copy_elements<std::uint8_t>(source, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copy_elements<std::int16_t>(source, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copy_elements<std::uint16_t>(source, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copy_elements<std::uint32_t>(source, out);
    default:
      return copy_elements<float>(source, out);
  }
}

ElementArray locate(const tinygltf::Model& model, int buffer_view, std::size_t offset,
                    ElementArray layout) {
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(buffer_view)];
  const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  const auto type = static_cast<std::uint32_t>(layout.component_type);
  const auto component = static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(type));
  layout.data = data.data() + view.byteOffset + offset;
  layout.stride = view.byteStride > 0 ? view.byteStride : layout.components * component;
  return layout;
}

std::vector<std::uint32_t> read_sparse_indices(const tinygltf::Model& model,
                                               const tinygltf::Accessor& accessor,
                                               const std::string& place) {
  const auto& sparse = accessor.sparse;
  ElementArray layout{.count = static_cast<std::size_t>(sparse.count),
                      .components = 1,
                      .component_type = sparse.indices.componentType};
  std::vector<std::uint32_t> indices(layout.count);
  read_elements(locate(model, sparse.indices.bufferView,
                       static_cast<std::size_t>(sparse.indices.byteOffset), layout),
                indices.data());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    vo::require(indices[i] < accessor.count, place, ": has the sparse index ", indices[i],
                ", expected one below ", accessor.count);
    vo::require(i == 0 || indices[i] > indices[i - 1], place, ": has the sparse index ", indices[i],
                " after one that is not smaller, expected increasing indices");
  }
  return indices;
}

template <typename Out>
void apply_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                  ElementArray layout, const std::string& place, Out* elements) {
  const std::vector<std::uint32_t> indices = read_sparse_indices(model, accessor, place);
  const auto& values_source = accessor.sparse.values;
  layout.count = indices.size();
  std::vector<Out> values(layout.count * layout.components);
  read_elements(locate(model, values_source.bufferView,
                       static_cast<std::size_t>(values_source.byteOffset), layout),
                values.data());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::copy_n(values.data() + i * layout.components, layout.components,
                elements + indices[i] * layout.components);
  }
}

bool has_bytes(const tinygltf::Model& model, int buffer_view) {
  if (buffer_view < 0) {
    return false;
  }
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(buffer_view)];
  return !model.buffers[static_cast<std::size_t>(view.buffer)].data.empty();
}

bool has_sparse_bytes(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
  return accessor.sparse.isSparse && has_bytes(model, accessor.sparse.indices.bufferView) &&
         has_bytes(model, accessor.sparse.values.bufferView);
}

/// Throws vo::Error beginning with `place` if a float element is not finite.
void require_finite(const ElementArray& elements, const std::string& place) {
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < elements.components; ++c) {
      float value = 0;
      std::memcpy(&value, elements.data + i * elements.stride + c * sizeof(value), sizeof(value));
      vo::require(std::isfinite(value), place, ": element ", i, " is infinite or not a number");
    }
  }
}

std::size_t components_of(const tinygltf::Accessor& accessor) {
  const auto type = static_cast<std::uint32_t>(accessor.type);
  return static_cast<std::size_t>(tinygltf::GetNumComponentsInType(type));
}

/// Reads all components of the accessor, sparse ones included, into `out`, which holds zeros.
template <typename Out>
void read_accessor(const tinygltf::Model& model, const tinygltf::Accessor& accessor,
                   const std::string& place, Out* out) {
  const ElementArray layout{.count = accessor.count,
                            .components = components_of(accessor),
                            .component_type = accessor.componentType,
                            .normalized = accessor.normalized};
  if (has_bytes(model, accessor.bufferView)) {
    read_elements(locate(model, accessor.bufferView, accessor.byteOffset, layout), out);
  }
  if (has_sparse_bytes(model, accessor)) {
    apply_sparse(model, accessor, layout, place, out);
  }
}

}  // namespace

template <typename Vector>
std::vector<Vector> read_vectors(const tinygltf::Model& model, int accessor,
                                 const std::string& place) {
  const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
  std::vector<Vector> vectors(source.count, Vector::Zero());
  read_accessor(model, source, place, vectors.front().data());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    vo::require(vectors[i].allFinite(), place, ": element ", i, " is infinite or not a number");
  }
  return vectors;
}

template std::vector<Eigen::Vector2f> read_vectors(const tinygltf::Model&, int, const std::string&);
template std::vector<Eigen::Vector3f> read_vectors(const tinygltf::Model&, int, const std::string&);
template std::vector<Eigen::Vector4f> read_vectors(const tinygltf::Model&, int, const std::string&);

std::vector<float> read_numbers(const tinygltf::Model& model, int accessor,
                                const std::string& place) {
  const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
  std::vector<float> numbers(source.count * components_of(source), 0);
  read_accessor(model, source, place, numbers.data());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    vo::require(std::isfinite(numbers[i]), place, ": number ", i, " is infinite or not a number");
  }
  return numbers;
}

std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor,
                                        const std::string& place) {
  const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
  std::vector<std::uint32_t> indices(source.count * components_of(source), 0);
  read_accessor(model, source, place, indices.data());
  return indices;
}

bool holds_data(const tinygltf::Model& model, int accessor) {
  const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
  return has_bytes(model, source.bufferView) || has_sparse_bytes(model, source);
}

void check_data(const tinygltf::Model& model, int accessor, const std::string& place) {
  const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
  const bool is_float = source.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  ElementArray layout{.count = source.count,
                      .components = components_of(source),
                      .component_type = source.componentType};
  if (is_float && has_bytes(model, source.bufferView)) {
    require_finite(locate(model, source.bufferView, source.byteOffset, layout), place);
  }
  if (!has_sparse_bytes(model, source)) {
    return;
  }
  layout.count = read_sparse_indices(model, source, place).size();
  if (is_float) {
    const auto& values = source.sparse.values;
    require_finite(
        locate(model, values.bufferView, static_cast<std::size_t>(values.byteOffset), layout),
        place + ": sparse values");
  }
}

}  // namespace synth
