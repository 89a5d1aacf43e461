#pragma once

#include "tools/make_scenes/model/model.h"

/// Things that lie on a desk: on y = 0, around the y axis.
namespace scenes {

Mesh worktop();                               ///< 1.8 x 0.8 m, 0.74 m high
Mesh sheet_of_paper(Finish print, int bent);  ///< A4, one corner up; `bent` selects how far
Mesh pencil_pot();
Mesh ruler();  ///< 0.32 m, along x
Mesh puzzle_cube();
Mesh mouse();
Mesh chess_board();  ///< 0.4 m, with some pieces
Mesh pinboard();     ///< 1.2 x 0.8 m, upright, its back at z = 0, around the origin

}  // namespace scenes
