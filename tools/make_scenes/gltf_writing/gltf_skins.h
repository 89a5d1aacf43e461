#pragma once

#include "tools/make_scenes/gltf_writing/gltf_document.h"
#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Writes the joints that a shape's vertices follow, and adds them to a primitive's attributes.
void add_joints(Document& document, const Shape& shape, Json& attributes);

/// Adds the model's skins, unless there are none.
void add_skins(Document& document, const Model& model);

}  // namespace scenes
