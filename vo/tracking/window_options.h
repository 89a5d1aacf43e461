#pragma once

#include <array>
#include <utility>

namespace vo {

/// What is adjusted of the newest keyframes when there is a new one.
enum class WindowAdjustment {
  none,
  poses,  ///< their poses
  depth,  ///< and the inverse depths of their points
};

constexpr auto enum_names(WindowAdjustment) {
  return std::array{std::pair{WindowAdjustment::none, "none"},
                    std::pair{WindowAdjustment::poses, "poses"},
                    std::pair{WindowAdjustment::depth, "depth"}};
}

/// Photometric bundle adjustment of the newest keyframes.
struct WindowOptions {
  WindowAdjustment adjust = WindowAdjustment::none;
  int moved = 3;             ///< newest keyframes whose poses are adjusted
  int held = 2;              ///< keyframes before them, aligned to but not moved
  int max_iterations = 6;    ///< of Levenberg and Marquardt
  double converged = 1e-4;   ///< share of the loss; a step that gains less is the last
  double min_overlap = 0.3;  ///< share of the points of one keyframe that another must see
  double depth_noise = 1;    ///< times what is known of the points' depth

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, WindowOptions& options) {
  visit("adjust", options.adjust,
        "what of the newest keyframes is adjusted when there is a new one");
  visit("moved", options.moved, "newest keyframes that are adjusted");
  visit("held", options.held, "keyframes before them that are aligned to as they are");
  visit("max_iterations", options.max_iterations, "of the adjustment");
  visit("converged", options.converged, "a step that gains less than this share is the last");
  visit("min_overlap", options.min_overlap,
        "share of a keyframe's points that another must see to be aligned to it");
  visit("depth_noise", options.depth_noise, "times what is known of the points' depth");
}

}  // namespace vo
