#pragma once

#include <initializer_list>
#include <vector>

#include "vo/tracking/local_map.h"
#include "vo/tracking/tracking_result.h"

namespace vo {

/// Returns the correlation of a keyframe's coarsest points with the frame seen from that pose, in
/// [-1, 1], or -1 if fewer than a third of the points are in view.
double coarse_agreement(const Keyframe& keyframe, const FramePyramid& frame,
                        const SE3& T_world_camera);

/// Returns the pose from which the frame agrees best with the keyframe, the earlier of equals.
/// There must be at least one guess.
SE3 best_guess(const Keyframe& keyframe, const FramePyramid& frame,
               std::initializer_list<SE3> T_world_camera_guesses);

/// Returns at most `count` poses from which the frame agrees best with the keyframe, best first.
std::vector<SE3> best_guesses(const Keyframe& keyframe, const FramePyramid& frame,
                              const std::vector<SE3>& T_world_camera_guesses, std::size_t count);

/// Returns the pose and that pose with the camera turned about all axes in steps of 4 deg, up to
/// about 14 deg, which covers a fast turn between two frames.
std::vector<SE3> turned_guesses(const SE3& T_world_camera);

/// Returns the poses of the keyframes that agree best with the frame, best first, at most `count`.
std::vector<SE3> similar_keyframes(const LocalMap& map, const FramePyramid& frame,
                                   std::size_t count);

/// Returns whether a frame aligned from one start is so doubtful that others are tried: it is lost,
/// or the correlation that it is judged by is weak.
bool is_doubtful(TrackingStatus status, double correlation);

/// Returns whether a pose that was searched for is preferred to the best one so far.
bool is_more_credible(const TrackingResult& found, const TrackingResult& best);

}  // namespace vo
