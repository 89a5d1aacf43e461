#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "vo/mapping/depth_map_options.h"
#include "vo/tracking/tracker_options.h"

namespace vo {

/// Where the first depths come from.
enum class MonoBootstrap {
  rgbd,       ///< the depth image of the first frame: metric
  file,       ///< a depth image that somebody else made, given with the first frame
  flat,       ///< one depth everywhere, found wrong by the observations
  random,     ///< random depths, likewise
  automatic,  ///< first frame held until parallax tells structure and motion at once
};

constexpr auto enum_names(MonoBootstrap) {
  return std::array{std::pair{MonoBootstrap::rgbd, "rgbd"}, std::pair{MonoBootstrap::file, "file"},
                    std::pair{MonoBootstrap::flat, "flat"},
                    std::pair{MonoBootstrap::random, "random"},
                    std::pair{MonoBootstrap::automatic, "auto"}};
}

struct MonoOptions {
  MonoBootstrap bootstrap = MonoBootstrap::automatic;
  double start_depth = 1;     ///< m, of a flat start; the median of an unknown one
  double start_sigma = 0.01;  ///< relative, of given depths
  std::uint64_t seed = 0;     ///< of random depths
  int min_confident = 150;    ///< hypotheses; fewer and the map is lost
  int max_lost_frames = 15;   ///< in a row; then a new map is started
  double parallax_px = 4;     ///< median, at 640 px width, that an unknown start needs at least
  double wanted_parallax_px = 12;  ///< likewise, that it waits for while corners are in view
  TrackerOptions tracker;
  DepthMapOptions map;

  void validate() const;  ///< throws Error
};

template <typename Visitor>
void visit_fields(Visitor& visit, MonoOptions& options) {
  visit("bootstrap", options.bootstrap, "where the first depths come from");
  visit("start_depth", options.start_depth, "flat start; median of an unknown one, m");
  visit("start_sigma", options.start_sigma, "of given depths, relative");
  visit("seed", options.seed, "of random depths");
  visit("min_confident", options.min_confident, "fewer confident hypotheses are a lost map");
  visit("max_lost_frames", options.max_lost_frames, "in a row, then a new map is started");
  visit("parallax_px", options.parallax_px,
        "median parallax that an unknown start needs, px at 640 px width");
  visit("wanted_parallax_px", options.wanted_parallax_px,
        "that it waits for while corners are in view, px at 640 px width");
  visit_fields(visit, options.tracker);
  visit("depth_map", options.map, "");
}

/// The tracker's best values for a map of its own making: no depth image to look up or to judge
/// with, hence not symmetric; points are weighted by what the map knows.
MonoOptions mono_options();

}  // namespace vo
