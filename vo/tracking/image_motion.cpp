#include "vo/tracking/image_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "vo/residuals/view_places.h"

namespace vo {

ImageMotion image_motion(const EdgePoints& points, const FramePyramid& frame,
                         const SE3& T_cur_ref) {
  const EdgePointLevel& level = points.levels.back();
  const PinholeCamera& camera = frame.levels.back().camera;
  const ViewPlacer placer(camera, T_cur_ref);
  ViewPlaces places;
  ImageMotion motion;
  double seen = 0;
  for (std::size_t first = 0; first < level.size(); first += ViewPlaces::kMost) {
    const std::size_t count = std::min(ViewPlaces::kMost, level.size() - first);
    placer.place(
        {level.x_ref.data() + first, level.y_ref.data() + first, level.z_ref.data() + first, count},
        places);
    for (std::size_t i = 0; i < count; ++i) {
      if (places.is_in_view(i)) {
        const float du = places.u[i] - static_cast<float>(level.pixel[first + i].x);
        const float dv = places.v[i] - static_cast<float>(level.pixel[first + i].y);
        seen += 1;
        motion.flow_px += std::sqrt(static_cast<double>(du * du + dv * dv));
      }
    }
  }
  if (seen > 0) {
    const double finest_px = frame.levels.front().camera.fx / camera.fx;
    motion.flow_px *= finest_px / seen;
    motion.overlap = seen / static_cast<double>(level.size());
  }
  return motion;
}

}  // namespace vo
