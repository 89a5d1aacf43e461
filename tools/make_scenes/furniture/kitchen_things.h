#pragma once

#include "tools/make_scenes/model/model.h"

/// Furniture of a kitchen: on y = 0, centred on the y axis, its front towards +z, unless a line
/// says otherwise. Glass is thin (KHR_materials_transmission without a volume).
namespace scenes {

inline constexpr double kCounterTop = 0.92;  ///< m

Mesh counter();     ///< 3.0 x 0.62 m, kCounterTop high, with a sink, an oven and a hob
Mesh splashback();  ///< 0.9 x 0.62 m of polished steel, its back at z = 0, y = 0 at its lower edge
Mesh hood();        ///< 0.9 m wide, its back at z = 0, y = 0 at its lower edge
Mesh glass_cabinet();  ///< 0.9 x 0.34 m, 0.72 high, two glass doors, its back at z = 0; see
                       ///< kCabinetShelf
Mesh fridge();         ///< 0.62 x 0.64 m, 1.86 m high, of brushed steel
Mesh glass_table();    ///< 1.3 x 0.8 m, 0.75 m high: glass on legs of steel
Mesh patio_window(double width, double height);  ///< two panes in a frame, around x = 0 and z = 0
Mesh wall_mirror();    ///< 0.7 x 1.3 m, its back at z = 0, around the origin
Mesh wine_glass();     ///< 0.2 m high
Mesh cooking_pot();    ///< 0.24 m across, of polished steel
Mesh ceiling_light();  ///< 0.9 x 0.9 m, shines downwards; y = 0 at the ceiling

inline constexpr double kCabinetShelf =
    0.37;  ///< m, top of the shelf above the cabinet's lower edge
inline constexpr double kCabinetFloor = 0.02;  ///< m, top of its floor

}  // namespace scenes
