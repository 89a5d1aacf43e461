#pragma once

#include "tools/make_scenes/model/model.h"

namespace scenes {

Mesh pendant_lamp();  ///< y = 0 at the ceiling; its light is kPendantDrop below
Mesh floor_lamp();    ///< shines upwards from kFloorLampLight
Mesh table_lamp();    ///< 0.42 m high, with a cloth shade

inline constexpr double kPendantDrop = 0.6;      ///< m, from the ceiling to below the bulb
inline constexpr double kFloorLampLight = 1.84;  ///< m above the floor, just above its bowl

}  // namespace scenes
