#pragma once

#include <vector>

#include <Eigen/Core>

#include "tools/make_scenes/model/model.h"

/// Parts of larger buildings. They stand on y = 0, centred on the y axis, unless a line says
/// otherwise.
namespace scenes {

/// An opening in a wall: its span along the wall's x, and from which height to which.
struct Opening {
  double left = 0;    ///< m
  double right = 0;   ///< m
  double bottom = 0;  ///< m
  double top = 0;     ///< m
};

/// Returns a wall in the plane z = 0, facing +z, from x = -width / 2 and y = 0, with openings that
/// are given from left to right and `depth` m deep.
Mesh pierced_wall(const Eigen::Vector2d& size, const std::vector<Opening>& openings, double depth,
                  Finish finish);

/// Returns a tall window of clear thin glass with glazing bars, y = 0 at its lower edge, around z =
/// 0.
Mesh tall_window(double width, double height);

Mesh column(double height);  ///< 0.44 m across, with base and capital
Mesh bench();                ///< 1.5 x 0.42 m, seat 0.45 m high
Mesh fountain();             ///< 2.2 m across, 1.5 m high
Mesh tree(double height);    ///< a trunk and a crown of leaves
Mesh planter();              ///< a wooden box of 0.9 x 0.4 x 0.4 m with plants
Mesh chandelier();  ///< 1.1 m across, y = 0 at the ceiling; its light is kChandelierDrop below

/// Steps from z = 0 towards -z: the first rises at z = 0.
struct Flight {
  int steps = 9;
  double rise = 0.17;   ///< m
  double going = 0.28;  ///< m
  double width = 1.2;   ///< m
};

Mesh flight_of_stairs(const Flight& flight);

/// Returns a handrail on posts, one on every other step, at x = 0 above a flight.
Mesh banister(const Flight& flight);

inline constexpr double kChandelierDrop = 1.5;  ///< m

}  // namespace scenes
