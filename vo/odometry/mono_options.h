#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "vo/mapping/depth_map_options.h"
#include "vo/tracking/tracker_options.h"

namespace vo {

/// The source of the first depths.
enum class MonoBootstrap {
  rgbd,       ///< the depth image of the first frame: metric
  file,       ///< a depth image from elsewhere, given with the first frame
  flat,       ///< one depth everywhere, corrected by the observations
  random,     ///< random depths, corrected by the observations
  automatic,  ///< the first frame waits until parallax determines structure and motion
};

constexpr auto enum_names(MonoBootstrap) {
  return std::array{std::pair{MonoBootstrap::rgbd, "rgbd"}, std::pair{MonoBootstrap::file, "file"},
                    std::pair{MonoBootstrap::flat, "flat"},
                    std::pair{MonoBootstrap::random, "random"},
                    std::pair{MonoBootstrap::automatic, "auto"}};
}

/// Returns whether the bootstrap gives metric depths.
constexpr bool is_metric(MonoBootstrap bootstrap) {
  return bootstrap == MonoBootstrap::rgbd || bootstrap == MonoBootstrap::file;
}

/// Returns whether the bootstrap's depths are guesses.
constexpr bool is_guess(MonoBootstrap bootstrap) {
  return bootstrap == MonoBootstrap::flat || bootstrap == MonoBootstrap::random;
}

/// Least median parallax of an unknown start, px at 640 px width.
inline constexpr double kMinStartParallaxPx = 4;

struct MonoOptions {
  MonoBootstrap bootstrap = MonoBootstrap::automatic;
  double start_depth = 1;          ///< m, depth of a flat start; median depth of an unknown one
  std::uint64_t seed = 0;          ///< seed of random depths
  int max_lost_frames = 15;        ///< consecutive lost frames after which a new map is started
  double wanted_parallax_px = 25;  ///< median that an unknown start waits for, px at 640 px width
  TrackerOptions tracker;
  DepthMapOptions map;

  void validate() const;  ///< throws Error if an option is invalid
};

template <typename Visitor>
void visit_fields(Visitor& visit, MonoOptions& options) {
  visit("bootstrap", options.bootstrap, "where the first depths come from");
  visit("start_depth", options.start_depth, "flat start; median of an unknown one, m");
  visit("seed", options.seed, "of random depths");
  visit("max_lost_frames", options.max_lost_frames, "in a row, then a new map is started");
  visit("wanted_parallax_px", options.wanted_parallax_px,
        "median that an unknown start waits for while corners are in view, px at 640 px width");
  visit_fields(visit, options.tracker);
  visit("depth_map", options.map, "");
}

/// Returns the tracker's best options for a map of its own making: not symmetric, because there is
/// no depth image to look up or to judge with; points are weighted by the map's uncertainty.
MonoOptions mono_options();

}  // namespace vo
