#pragma once

#include "tools/make_scenes/model/model.h"

/// One function per scene that is committed under assets/, each in a file of its own. All are in
/// metres with y up, and but for plane_and_box stand on the floor y = 0 around the origin.
namespace scenes {

Model make_room();           ///< a furnished living room, 6 x 5 x 2.7 m
Model make_corridor();       ///< 24 x 2.2 x 2.6 m along z, the same every 3 m
Model make_desk();           ///< a cluttered desk, to be seen from near
Model make_white_room();     ///< hardly anything but shading
Model make_plane_and_box();  ///< closed form, unlit; assets/README.md gives its dimensions
Model make_moving_room();    ///< a door swings, a ball rolls, a crate drives: all within 8 s

}  // namespace scenes
