#pragma once

namespace vo {

/// The greatest distance from the world's origin, m, along each axis: of positions in files and of
/// what a scene shows. Squares of it are far from the greatest number of 32-bit floats, 3.4e38.
inline constexpr double kMaxMetres = 1e9;

}  // namespace vo
