#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synth/path_planning/free_space.h"

namespace synth {

/// Places where a camera can be, and the straight ways between them.
struct Roadmap {
  struct Way {
    std::size_t to = 0;
    double length = 0;  ///< m
  };

  std::vector<Eigen::Vector3d> places;  ///< m, world
  std::vector<std::vector<Way>> ways;   ///< from each place
};

/// Where a scene can be explored, and how large what is there looks.
struct ExploredRegion {
  Eigen::AlignedBox3d box;  ///< m, world
  bool is_inside = false;   ///< surfaces to all sides, whose fronts are seen
  double scale = 0;         ///< m: three quarters of the surfaces around a place are nearer
};

/// Inside of what is there if there is an inside, around it otherwise. Where the inside is so large
/// that it must be the space under a sky, and there are rooms beside surfaces, it is the rooms.
/// Throws vo::Error when there is nothing to see from anywhere.
ExploredRegion find_region(const FreeSpace& space, std::uint64_t seed);

/// Probabilistic roadmap (Kavraki et al. 1996): random places in the region, each connected to its
/// nearest ones where a ball of `radius`, m, can go straight; the largest connected part of it.
/// Empty when no two places are connected.
Roadmap make_roadmap(const FreeSpace& space, const ExploredRegion& region, double radius,
                     std::uint64_t seed);

/// A way along the roadmap of at least `length`, m: from place to place by the shortest ways, each
/// time to the one of some random places that is farthest from those visited.
std::vector<Eigen::Vector3d> wander(const Roadmap& roadmap, double length, std::uint64_t seed);

}  // namespace synth
