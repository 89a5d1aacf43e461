#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synth/path_planning/free_space.h"

namespace synth {

/// A roadmap: positions where a camera can be, and the straight edges between them.
struct Roadmap {
  struct Way {
    std::size_t to = 0;
    double length = 0;  ///< m, length of the edge
  };

  std::vector<Eigen::Vector3d> places;  ///< m, world
  std::vector<std::vector<Way>> ways;   ///< edges from each place
};

/// The region of a scene that can be explored, and its scale.
struct ExploredRegion {
  Eigen::AlignedBox3d box;  ///< m, world; bounds of the region
  bool is_inside = false;   ///< whether surfaces enclose it and show their fronts
  double scale = 0;         ///< m, median over positions of Surroundings::far_distance
};

/// Returns the inside of the scene if there is one, else the space around it. Where the inside is
/// so large that it must be the space under a sky, and there are rooms beside surfaces, the scale
/// is that of the rooms. Throws vo::Error when no position sees any surface.
ExploredRegion find_region(const FreeSpace& space, std::uint64_t seed);

/// Returns a probabilistic roadmap (Kavraki et al. 1996): random places in the region, each
/// connected to its nearest ones where a ball of `radius`, m, can move straight; only the largest
/// connected component is kept. The roadmap is empty when no two places are connected.
Roadmap make_roadmap(const FreeSpace& space, const ExploredRegion& region, double radius,
                     std::uint64_t seed);

/// Returns a polyline along the roadmap, m, world, of at least `length`, m: shortest paths from
/// place to place, each to the one of some random places that is farthest from those visited.
std::vector<Eigen::Vector3d> wander(const Roadmap& roadmap, double length, std::uint64_t seed);

}  // namespace synth
