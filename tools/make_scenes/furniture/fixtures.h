#pragma once

#include <optional>

#include <Eigen/Core>

#include "tools/make_scenes/model/model.h"

/// Parts of the building. Things on a wall have it as the plane z = 0, facing +z.
namespace scenes {

inline constexpr double kHalfWidth = 3.0;  ///< m, along x
inline constexpr double kHalfDepth = 2.5;  ///< m, along z
inline constexpr double kHeight = 2.7;     ///< m

/// The window's opening in the wall x = kHalfWidth.
inline constexpr double kWindowZ = -0.2;      ///< m, z of its centre
inline constexpr double kWindowWidth = 1.6;   ///< m
inline constexpr double kWindowSill = 0.95;   ///< m above the floor
inline constexpr double kWindowHeight = 1.3;  ///< m

/// Finishes of a plain room. A wall without a finish is left out.
struct ShellFinishes {
  Finish floor, ceiling;
  std::optional<Finish> north;  ///< wall at z < 0
  Finish east, south, west;     ///< walls at x > 0, z > 0, x < 0
};

/// Returns floor, ceiling and walls of a room of `size` (m), centred in x and z, with the floor at
/// y = 0.
Mesh plain_shell(const Eigen::Vector3d& size, const ShellFinishes& finishes);

Mesh shell();    ///< floor, walls, ceiling and beams of the furnished room
Mesh window();   ///< frame and sill; y = 0 is the sill, z = 0 the wall's inner face
Mesh curtain();  ///< 0.5 m wide, y = 0 at its top
Mesh curtain_rod();
Mesh view();      ///< the outdoor image, upright, around the origin
Mesh door();      ///< door and frame; y = 0 is the floor
Mesh radiator();  ///< y = 0 at its lower edge
Mesh skirting(double length);
Mesh light_switch();

}  // namespace scenes
