#pragma once

#include "synth/gltf_document/json_object.h"

namespace synth {

/// The name of the glTF extension by which a scene has light from all sides.
inline constexpr const char* kImageBasedLightExtension = "EXT_lights_image_based";

/// Checks the document's lights of EXT_lights_image_based and the scenes' references to them.
/// Throws vo::Error.
void check_image_based_lights(const JsonObject& root);

}  // namespace synth
