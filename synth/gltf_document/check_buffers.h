#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "synth/gltf_document/json_object.h"
#include "synth/gltf_document/notes.h"

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

/// Throws vo::Error beginning with `place` if the accessor's buffer view has a byteStride, which
/// only vertex attributes may have, unless it changes nothing: the accessor has one element, or the
/// stride is its element's size. That is noted.
void require_packed(const JsonObject& accessor, const std::vector<JsonObject>& views,
                    const std::string& place, Notes& notes);

/// Checks sizes, types and ranges of buffers, buffer views and accessors: every accessor lies in
/// its buffer as declared. A byteStride that glTF does not allow is noted where no accessor is read
/// differently without it. Throws vo::Error.
void check_buffers(const JsonObject& root, Notes& notes);

}  // namespace synth
