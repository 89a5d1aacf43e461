#pragma once

#include <array>
#include <utility>

#include "synth/depth_sensor/depth_noise.h"
#include "synth/rendering/capture.h"
#include "synth/rendering/renderer.h"

namespace synth {

enum class ClearSurface {
  surface,  ///< measured as any other surface
  beyond,   ///< what glass lets through and mirrors reflect is measured instead
  lost,     ///< nothing is measured
};

constexpr auto enum_names(ClearSurface) {
  return std::array{std::pair{ClearSurface::surface, "surface"},
                    std::pair{ClearSurface::beyond, "beyond"},
                    std::pair{ClearSurface::lost, "lost"}};
}

/// DepthMaterials says what a depth camera measures at the glass and the mirrors of FirstSurface,
/// and how much light a surface must return.
struct DepthMaterials {
  ClearSurface glass = ClearSurface::surface;
  ClearSurface mirrors = ClearSurface::surface;
  SolidGlass solids = SolidGlass::straight;  ///< on the way to what is beyond glass
  double min_return = 0;  ///< least light that returns, as in DepthSight; 0 = any

  bool is_on() const;
};

template <typename Visitor>
void visit_fields(Visitor& visit, DepthMaterials& materials) {
  visit("glass", materials.glass, "what is measured where smooth glass is in front");
  visit("mirrors", materials.mirrors, "what is measured where a mirror is in front");
  visit("solids", materials.solids, "how light goes through solids of glass to what is beyond");
  visit("min_return", materials.min_return,
        "least light of its own that returns, as a share of what a white wall returns from 1 m; "
        "0 = any");
}

/// Returns what a depth camera measures, without noise, of a frame with depth and normals. Without
/// DepthSight, which not every renderer makes, that is the first surface of each pixel.
DepthView seen_by_depth_camera(const RenderedFrame& frame, const DepthMaterials& materials);

}  // namespace synth
