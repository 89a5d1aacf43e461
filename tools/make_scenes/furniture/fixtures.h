#pragma once

#include <optional>

#include <Eigen/Core>

#include "tools/make_scenes/model/model.h"

/// What belongs to the building. Things on a wall have it as the plane z = 0, facing +z.
namespace scenes {

inline constexpr double kHalfWidth = 3.0;  ///< m, along x
inline constexpr double kHalfDepth = 2.5;  ///< m, along z
inline constexpr double kHeight = 2.7;     ///< m

/// The window's hole in the wall x = kHalfWidth.
inline constexpr double kWindowZ = -0.2;      ///< m, its centre
inline constexpr double kWindowWidth = 1.6;   ///< m
inline constexpr double kWindowSill = 0.95;   ///< m above the floor
inline constexpr double kWindowHeight = 1.3;  ///< m

/// What a plain room is made of. A wall without a finish is left out.
struct ShellFinishes {
  Finish floor, ceiling;
  std::optional<Finish> north;  ///< z < 0
  Finish east, south, west;     ///< x > 0, z > 0, x < 0
};

/// Floor, ceiling and walls around the origin, x and z to both sides, y = 0 the floor, m.
Mesh plain_shell(const Eigen::Vector3d& size, const ShellFinishes& finishes);

Mesh shell();    ///< floor, walls, ceiling and beams of the furnished room
Mesh window();   ///< frame and sill; y = 0 is the sill, z = 0 the wall's inner face
Mesh curtain();  ///< 0.5 m wide, y = 0 at its top
Mesh curtain_rod();
Mesh view();      ///< what is outside, upright, around the origin
Mesh door();      ///< with its frame, y = 0 the floor
Mesh radiator();  ///< y = 0 at its lower edge
Mesh skirting(double length);
Mesh light_switch();

}  // namespace scenes
