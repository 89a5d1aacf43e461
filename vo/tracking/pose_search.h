#pragma once

#include <vector>

#include "vo/tracking/local_map.h"

namespace vo {

/// Correlation of a keyframe's coarsest points with the frame if it were seen from there, in
/// [-1, 1]; -1 where fewer than a third of them are in view.
double coarse_agreement(const Keyframe& keyframe, const FramePyramid& frame,
                        const SE3& T_world_camera);

/// The pose from which the frame agrees best with the keyframe; the earlier of equals. There must
/// be one.
SE3 best_guess(const Keyframe& keyframe, const FramePyramid& frame,
               const std::vector<SE3>& T_world_camera_guesses);

/// The poses from which the frame agrees best with the keyframe, best first, at most `count`.
std::vector<SE3> best_guesses(const Keyframe& keyframe, const FramePyramid& frame,
                              const std::vector<SE3>& T_world_camera_guesses, std::size_t count);

/// The pose and what becomes of it by turning the camera about all axes in steps, up to about 12
/// deg: what a fast turn between two frames may have done.
std::vector<SE3> turned_guesses(const SE3& T_world_camera);

/// The poses of the keyframes that agree best with the frame, best first, at most `count`.
std::vector<SE3> similar_keyframes(const LocalMap& map, const FramePyramid& frame,
                                   std::size_t count);

}  // namespace vo
