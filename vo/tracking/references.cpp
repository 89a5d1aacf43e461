#include "vo/tracking/references.h"

#include <algorithm>
#include <utility>

namespace vo {

bool References::velocities_known() const {
  return std::all_of(keyframes.begin(), keyframes.end(),
                     [](const auto& keyframe) { return keyframe->velocity.has_value(); });
}

bool References::are_disturbed() const {
  return std::any_of(keyframes.begin(), keyframes.end(),
                     [](const auto& keyframe) { return keyframe->is_disturbed(); });
}

void References::leave_out(const TileMask& tiles, const FramePyramid& current,
                           const SE3& T_world_camera) {
  InplaceVector<AlignReference, kMaxReferences> left;
  for (std::size_t r = 0; r < keyframes.size(); ++r) {
    const SE3 T_cur_ref = T_world_camera.inverse() * keyframes[r]->T_world_keyframe;
    const SeenTiles seen{tiles, current, T_cur_ref};
    auto fewer_points = std::make_shared<EdgePoints>(*points[r]);
    vo::leave_out(seen, *fewer_points);
    points[r] = std::move(fewer_points);
    if (surfaces[r] != nullptr) {
      auto fewer_surfaces = std::make_shared<SurfacePoints>(*surfaces[r]);
      vo::leave_out(seen, *fewer_surfaces);
      surfaces[r] = std::move(fewer_surfaces);
    }
    const AlignReference& view = views[r];
    left.push_back({*points[r], view.T_first_ref, view.frame, view.velocity, surfaces[r].get(),
                    view.vignette});
  }
  views = left;
}

}  // namespace vo
