#pragma once

#include "tools/make_scenes/gltf_writing/gltf_document.h"
#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Adds the model's motions as one animation, unless there are none.
void add_animations(Document& document, const Model& model);

}  // namespace scenes
