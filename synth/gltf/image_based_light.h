#pragma once

#include <optional>

#include "synth/gltf/gltf.h"
#include "synth/gltf_model/gltf_model.h"
#include "synth/scene/scene.h"

namespace synth {

/// Returns the light from all sides that one of the file's scenes has by EXT_lights_image_based,
/// and none if the scene has none, the options name another environment or `needed` leaves it out.
///
/// It is the largest level of the specular cube map, as radiance. Each face is the picture that a
/// viewer in the middle sees, y up (for the faces +y and -y with +z and -z at its lower edge): the
/// extension's "standard orientation" of OpenGL's cube maps, "flipped about its vertical axis". A
/// texel is sRGB, over its alpha where the image has one (RGBD). Smaller levels and irradiance
/// coefficients, which hold the same light blurred, are not read. Throws vo::Error if an image
/// cannot be decoded, is not a square of at most 2048 px or the faces' sizes differ.
Environment read_image_based_light(const GltfModel& model, std::optional<int> scene,
                                   const GltfOptions& options, Notes& notes);

}  // namespace synth
