#pragma once

#include "tools/make_scenes/model/model.h"

/// Furniture stands on y = 0, centred on the y axis, its front towards +z.
namespace scenes {

Mesh chair();
Mesh sofa();
Mesh cushion(Finish fabric);

}  // namespace scenes
