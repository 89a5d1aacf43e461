#pragma once

#include "tools/make_scenes/model/model_builder.h"

namespace scenes {

inline constexpr double kVisitorPeriod = 6.4;  ///< s, to the other end of the walk and back
inline constexpr double kVisitorWalk = 2.4;    ///< m

/// Adds a person of 1.75 x 0.54 m who walks to and fro at 1.1 m/s between z = -kVisitorWalk / 2 and
/// z = kVisitorWalk / 2 of `parent`, on y = 0, and rests at the first of them.
void add_visitor(ModelBuilder& scene, int parent);

}  // namespace scenes
