#pragma once

#include <optional>
#include <string>
#include <vector>

#include "synth/gltf_model/gltf_reading.h"
#include "synth/scene/scene.h"

namespace synth {

/// The geometry of a mesh primitive in the frame of its mesh.
struct PrimitiveGeometry {
  Mesh mesh;  ///< the material is left as kNone
  std::vector<MorphTarget> targets;
};

/// Reads a mesh primitive; nothing for points, lines and primitives without positions. Throws
/// vo::Error beginning with `place` for indices out of range and values that are not finite.
std::optional<PrimitiveGeometry> read_primitive(GltfReading& reading,
                                                const tinygltf::Primitive& primitive,
                                                const std::string& place);

}  // namespace synth
