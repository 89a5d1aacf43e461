#pragma once

#include <array>

#include "tools/make_scenes/model/model.h"

namespace scenes {

Mesh bookcase();    ///< 1.6 x 0.32 m, 2.05 m high, two columns; see kShelfHeights
Mesh sideboard();   ///< 1.5 x 0.42 m, 0.8 m high
Mesh wall_shelf();  ///< 1.1 x 0.22 m, its back at z = 0, its top at y = 0
Mesh parcel(const Eigen::Vector3d& size);
Mesh basket();

inline constexpr double kBookcaseColumn = 0.39;  ///< m from the centre to a column's centre
inline constexpr std::array kShelfHeights = {0.102, 0.492, 0.882, 1.272, 1.662};  ///< m, shelf tops

}  // namespace scenes
