#include "synth/depth_sensor/depth_materials.h"

namespace synth {
namespace {

ClearSurface measured_at(FirstSurface first, const DepthMaterials& materials) {
  switch (first) {
    case FirstSurface::glass:
      return materials.glass;
    case FirstSurface::mirror:
      return materials.mirrors;
    case FirstSurface::opaque:
      break;
  }
  return ClearSurface::surface;
}

}  // namespace

bool DepthMaterials::is_on() const {
  return glass != ClearSurface::surface || mirrors != ClearSurface::surface || min_return > 0;
}

DepthView seen_by_depth_camera(const RenderedFrame& frame, const DepthMaterials& materials) {
  const DepthSight& sight = frame.sight;
  if (sight.first.empty()) {
    return {frame.depth, frame.normal};
  }
  DepthView view{frame.depth.clone(), frame.normal.clone()};
  for (int v = 0; v < view.depth.rows; ++v) {
    for (int u = 0; u < view.depth.cols; ++u) {
      const ClearSurface measured =
          measured_at(static_cast<FirstSurface>(sight.first(v, u)), materials);
      const bool is_beyond = measured == ClearSurface::beyond;
      if (is_beyond) {
        view.depth(v, u) = sight.beyond(v, u);
        view.normal(v, u) = sight.beyond_normal(v, u);
      }
      const float returned = is_beyond ? sight.beyond_returned(v, u) : sight.returned(v, u);
      if (measured == ClearSurface::lost || returned < materials.min_return) {
        view.depth(v, u) = 0;
        view.normal(v, u) = cv::Vec3f(0, 0, 0);
      }
    }
  }
  return view;
}

}  // namespace synth
