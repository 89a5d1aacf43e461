#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "synth/gltf_document/json_object.h"

namespace synth {

/// Whether glTF's componentType is one of the unsigned integers.
bool is_unsigned_component(std::size_t component_type);

/// Bytes from one element of an accessor to the next where no byteStride says otherwise; none if
/// its type or componentType is not glTF 2.0's, so that it cannot be read.
std::optional<std::size_t> packed_stride(const JsonObject& accessor);

/// Each throws vo::Error beginning with `place` when the accessor is of another type.
void require_element_type(const JsonObject& accessor, const std::string& type,
                          const std::string& place);
void require_float_components(const JsonObject& accessor, const std::string& place);

/// Throws vo::Error beginning with `place` when the bufferView of `object` has a byteStride, which
/// vertices alone may have.
void require_packed(const JsonObject& object, const std::vector<JsonObject>& views,
                    const std::string& place);

/// Checks sizes, types and ranges of buffers, buffer views and accessors: every accessor lies in
/// its buffer as declared. Throws vo::Error.
void check_buffers(const JsonObject& root);

}  // namespace synth
