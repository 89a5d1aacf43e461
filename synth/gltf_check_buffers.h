#pragma once

#include <cstddef>

#include "synth/gltf_json.h"

namespace synth {

/// Whether glTF's componentType is one of the unsigned integers.
bool is_unsigned_component(std::size_t component_type);

/// Checks sizes, types and ranges of buffers, buffer views and accessors: every accessor lies in
/// its buffer as declared. Throws vo::Error.
void check_buffers(const JsonObject& root);

}  // namespace synth
