#pragma once

#include "tools/make_scenes/model/model.h"

/// One function per scene committed under assets/, each in its own file. All are in metres with y
/// up; all but plane_and_box stand on the floor y = 0 around the origin.
namespace scenes {

Model make_room();           ///< a furnished living room, 6 x 5 x 2.7 m
Model make_corridor();       ///< 24 x 2.2 x 2.6 m along z, repeated every 3 m
Model make_desk();           ///< a cluttered desk for close-up views
Model make_white_room();     ///< white surfaces with shading but little texture
Model make_plane_and_box();  ///< unlit, for closed-form truth; see assets/README.md
Model make_visited_room();   ///< a person walks to and fro in it, period 6.4 s
Model make_walker();         ///< a skinned figure that walks on the spot, facing +z; an actor
Model make_kitchen();        ///< steel, glass and a mirror, 4 x 4.4 x 2.5 m
Model make_hall();           ///< columns and tall windows with sun, 7 x 12 x 4.2 m
Model make_staircase();      ///< two flights and a landing, 2.8 x 5.6 x 5.8 m
Model make_courtyard();      ///< walls, trees and a fountain under the open sky, 10 x 12 m
Model make_moving_room();    ///< animated door, ball and crate, period 8 s

}  // namespace scenes
