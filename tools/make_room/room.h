#pragma once

#include "tools/make_room/model.h"

namespace room {

/// A furnished living room of 6 x 5 x 2.7 m, y up, the origin in the middle of the floor; the
/// window is in the wall towards +x, the brick wall towards -z, the plain one towards +z.
Model make_room();

}  // namespace room
