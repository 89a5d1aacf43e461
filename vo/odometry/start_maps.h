#pragma once

#include "vo/bootstrap/mono_initialiser.h"
#include "vo/core/image.h"
#include "vo/image/pyramid.h"
#include "vo/mapping/depth_map.h"
#include "vo/odometry/mono_options.h"

namespace vo {

/// Returns a host's map with the depths, m, of a depth image of its size.
DepthMap measured_map(const FramePyramid& host, const DepthImage& depth,
                      const MonoOptions& options);

/// Returns a host's map whose depths are guesses: this one, m, or random where the options say so.
DepthMap guessed_map(const FramePyramid& host, double depth, const MonoOptions& options);

/// Returns the map of the held frame of a solved start, its edges observed in all other frames. The
/// depth, m, is that of edges far from all corners.
DepthMap solved_map(const MonoInitialiser& solved, double depth, const MonoOptions& options);

}  // namespace vo
