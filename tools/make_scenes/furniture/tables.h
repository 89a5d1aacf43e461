#pragma once

#include "tools/make_scenes/model/model.h"

namespace scenes {

Mesh dining_table();  ///< 1.4 x 0.8 m, 0.75 m high
Mesh coffee_table();  ///< 1.0 x 0.6 m, 0.42 m high
Mesh side_table();    ///< 0.42 m across, 0.5 m high
Mesh desk();          ///< 1.3 x 0.65 m, 0.75 m high

}  // namespace scenes
