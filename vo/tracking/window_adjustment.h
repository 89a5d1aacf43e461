#pragma once

#include <vector>

#include "vo/geometry/se3.h"
#include "vo/image/edge_points.h"
#include "vo/image/pyramid.h"
#include "vo/residuals/align_options.h"
#include "vo/residuals/frame_velocity.h"
#include "vo/tracking/window_options.h"

namespace vo {

/// A keyframe while a window of them is adjusted.
struct WindowFrame {
  const PyramidLevel* image = nullptr;
  EdgePointLevel points;
  std::vector<float> measured_depth;  ///< m, of each point: what its depth is held to
  SE3 T_frame_world;
  FrameVelocity velocity;
  bool held = false;  ///< its pose
};

/// Photometric bundle adjustment: the points of every frame looked up in every other that sees
/// enough of them. Poses, brightness of each pair and, where the options say so, the points'
/// inverse depths together, by Levenberg and Marquardt's steps; depths and brightness are
/// eliminated frame by frame (Schur complement; Triggs, McLauchlan, Hartley, Fitzgibbon, "Bundle
/// Adjustment - A Modern Synthesis", 2000; Engel, Koltun, Cremers, "Direct Sparse Odometry", PAMI
/// 2018). A point's inverse depth is held to what was measured as firmly as its `depth_sigma` says.
/// At least one frame must be held.
void adjust_window(std::vector<WindowFrame>& frames, const WindowOptions& window,
                   const AlignOptions& options);

/// The same pixels at other depths, m.
EdgePointLevel at_depths(const EdgePointLevel& points, const std::vector<float>& depth);

}  // namespace vo
