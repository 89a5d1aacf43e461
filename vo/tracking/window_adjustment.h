#pragma once

#include <vector>

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/align_options.h"
#include "vo/residuals/frame_velocity.h"
#include "vo/tracking/window_options.h"

namespace vo {

/// A keyframe in a window that is adjusted.
struct WindowFrame {
  const PyramidLevel* image = nullptr;
  EdgePointLevel points;
  std::vector<float> measured_depth;  ///< m, prior of each point's depth
  SE3 T_frame_world;
  FrameVelocity velocity;
  bool held = false;  ///< whether the pose is fixed
};

/// Adjusts a window of frames by photometric bundle adjustment: the points of every frame are
/// looked up in every other that sees enough of them. Levenberg-Marquardt steps estimate the poses,
/// the brightness of each pair and, where the options say so, the points' inverse depths; depths
/// and brightness are eliminated frame by frame (Schur complement; Triggs, McLauchlan, Hartley,
/// Fitzgibbon, "Bundle Adjustment - A Modern Synthesis", 2000; Engel, Koltun, Cremers, "Direct
/// Sparse Odometry", PAMI 2018). The prior of a point's inverse depth is its measured depth with
/// standard deviation `depth_sigma`. At least one frame must be held.
void adjust_window(std::vector<WindowFrame>& frames, const WindowOptions& window,
                   const AlignOptions& options);

/// Returns the points of these pixels at other depths, m.
EdgePointLevel at_depths(const EdgePointLevel& points, const std::vector<float>& depth);

}  // namespace vo
