#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "vo/geometry/trajectory.h"

namespace vo {

/// Returns the stamps of a trajectory's poses plus an offset, s.
std::vector<double> timestamps_of(const Trajectory& trajectory, double offset = 0);

/// Returns pairs (index in a, index in b) of stamps that belong together, as associate.py of the
/// TUM RGB-D benchmark: of all pairs closer than `max_difference` the closest is taken first, the
/// earlier of two equally close ones, and each stamp is used once. Equal stamps belong together
/// even if `max_difference` is 0. Stamps are in s and strictly increasing; the result is in
/// increasing order of the first index.
std::vector<std::pair<std::size_t, std::size_t>> associate(std::span<const double> a,
                                                           std::span<const double> b,
                                                           double max_difference);

}  // namespace vo
