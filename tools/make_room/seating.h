#pragma once

#include "tools/make_room/model.h"

/// Furniture stands on y = 0, centred on the y axis, its front towards +z.
namespace room {

Mesh chair();
Mesh sofa();
Mesh cushion(Finish fabric);

}  // namespace room
