#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "synth/gltf_document/json_object.h"

namespace synth {

/// Returns whether glTF's componentType is an unsigned integer type.
bool is_unsigned_component(std::size_t component_type);

/// Returns the bytes from one element of an accessor to the next if there is no byteStride; nothing
/// if its type or componentType is not in glTF 2.0, so that it cannot be read.
std::optional<std::size_t> packed_stride(const JsonObject& accessor);

/// Throws vo::Error beginning with `place` unless the accessor's type is `type`.
void require_element_type(const JsonObject& accessor, const std::string& type,
                          const std::string& place);
/// Throws vo::Error beginning with `place` unless the accessor's components are floats.
void require_float_components(const JsonObject& accessor, const std::string& place);

/// Throws vo::Error beginning with `place` if the buffer view of `object` has a byteStride, which
/// only vertex attributes may have.
void require_packed(const JsonObject& object, const std::vector<JsonObject>& views,
                    const std::string& place);

/// Checks sizes, types and ranges of buffers, buffer views and accessors: every accessor lies in
/// its buffer as declared. Throws vo::Error.
void check_buffers(const JsonObject& root);

}  // namespace synth
