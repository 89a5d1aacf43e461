#pragma once

#include <optional>
#include <string>

#include "synth/gltf.h"
#include "synth/gltf_model.h"
#include "synth/scene.h"

namespace synth {

/// The triangles of a primitive in the frame of its mesh; the material is left as kNone. Nothing
/// for points, lines and primitives without positions. Throws vo::Error beginning with `place`
/// for vertex indices out of range and values that are not finite.
std::optional<Mesh> read_primitive(const GltfModel& model, const tinygltf::Primitive& primitive,
                                   const std::string& place, Notes& notes);

}  // namespace synth
