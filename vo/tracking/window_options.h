#pragma once

#include <array>
#include <cstddef>
#include <utility>

namespace vo {

/// The quantities of the newest keyframes that are adjusted when there is a new one.
enum class WindowAdjustment {
  none,
  poses,  ///< the keyframes' poses
  depth,  ///< the keyframes' poses and their points' inverse depths
};

constexpr auto enum_names(WindowAdjustment) {
  return std::array{std::pair{WindowAdjustment::none, "none"},
                    std::pair{WindowAdjustment::poses, "poses"},
                    std::pair{WindowAdjustment::depth, "depth"}};
}

/// Most keyframes of a window.
inline constexpr std::size_t kMaxWindow = 40;

/// Photometric bundle adjustment of the newest keyframes.
struct WindowOptions {
  WindowAdjustment adjust = WindowAdjustment::none;
  int moved = 3;             ///< number of newest keyframes whose poses are adjusted
  int held = 2;              ///< number of keyframes before them, with fixed poses
  int max_iterations = 6;    ///< most Levenberg-Marquardt iterations
  double converged = 1e-4;   ///< share of the loss; the step that gains less is the last
  double min_overlap = 0.3;  ///< share of the points of one keyframe that another must see
  double depth_noise = 1;    ///< factor on the points' depth_sigma

  void validate() const;  ///< throws Error if an option is invalid
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
