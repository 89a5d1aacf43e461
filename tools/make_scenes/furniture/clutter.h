#pragma once

#include "tools/make_scenes/model/model.h"

namespace scenes {

Mesh fruit_bowl();
Mesh cup(const Color& color);
Mesh bottle();
Mesh plate();
Mesh packet(const Eigen::Vector3d& size, const Color& color);
Mesh building_blocks();
Mesh monitor();
Mesh laptop();
Mesh keyboard();

}  // namespace scenes
