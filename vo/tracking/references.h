#pragma once

#include <memory>

#include "vo/alignment/joint_problem.h"
#include "vo/core/inplace_vector.h"
#include "vo/segmentation/tile_mask.h"
#include "vo/tracking/local_map.h"

namespace vo {

/// The keyframes that a frame is aligned to, what is used of each, and their views.
struct References {
  LocalMap::References keyframes;
  InplaceVector<std::shared_ptr<const EdgePoints>, kMaxReferences> points;
  /// Surface points, null where none are compared.
  InplaceVector<std::shared_ptr<const SurfacePoints>, kMaxReferences> surfaces;
  InplaceVector<AlignReference, kMaxReferences> views;  ///< one per keyframe, with its points

  bool velocities_known() const;  ///< the first one is known a frame later
  bool are_disturbed() const;     ///< whether one of them is

  /// Leaves out what is seen in these tiles of a frame taken at this pose.
  void leave_out(const TileMask& tiles, const FramePyramid& current, const SE3& T_world_camera);
};

}  // namespace vo
