#pragma once

#include "vo/geometry/se3.h"
#include "vo/image/pyramid.h"
#include "vo/image/view_grid.h"

namespace vo {

/// Adds `evidence` to the tiles of a level's depths, once for each depth that is clearly nearer
/// than where another frame saw through: a violation of free space, which no static scene has. Both
/// levels must have depth.
void add_seen_through(const PyramidLevel& own, const PyramidLevel& other, const SE3& T_other_own,
                      float evidence, ViewTiles::Values& sum);

}  // namespace vo
