#pragma once

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Returns a framed picture of the given size (m), its back at z = 0, centred on the origin.
Mesh framed_picture(Finish picture, const Eigen::Vector2d& size, Finish frame);

/// Returns a picture pinned to the wall at z = 0, its corners slightly off it.
Mesh pinned_picture(Finish picture, const Eigen::Vector2d& size);

Mesh wall_clock();  ///< 0.32 m across, its back at z = 0
Mesh rug();         ///< 2.2 x 1.6 m
Mesh doormat();
Mesh globe();
Mesh vase();
Mesh potted_plant();  ///< about 1.5 m high
Mesh small_plant();   ///< about 0.3 m high

}  // namespace scenes
