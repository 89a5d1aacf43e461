#pragma once

#include <array>

#include "synth/gltf_document/json_object.h"

namespace synth {

/// The name of the glTF extension by which a node shows many instances of its mesh.
inline constexpr const char* kInstancingExtension = "EXT_mesh_gpu_instancing";

/// The attributes of EXT_mesh_gpu_instancing that place an instance.
inline constexpr std::array kInstancingAttributes = {"TRANSLATION", "ROTATION", "SCALE"};

/// Checks the types and counts of the attributes that nodes with EXT_mesh_gpu_instancing have.
/// Throws vo::Error.
void check_instancing(const JsonObject& root);

}  // namespace synth
