#pragma once

#include "vo/mapping/depth_map_options.h"
#include "vo/mapping/epipolar_search.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// How far an observation is from what hypothesis i expects.
struct Innovation {
  float difference = 0;  ///< 1/m
  float variance = 0;    ///< 1/m^2
};

Innovation innovation(const Observation& observation, std::size_t i, const Hypotheses& hypotheses);

/// Takes a successful observation into hypothesis i. The first of a guess replaces it, later ones
/// are fused.
void fuse(const Observation& observation, const DepthMapOptions& options, std::size_t i,
          Hypotheses& hypotheses);

/// Counts a failed observation of hypothesis i. One that fails too often, or is not confirmed, is
/// forgotten: a guess of the given inverse depth, 1/m, takes its place.
void count_failure(const DepthMapOptions& options, float guess, std::size_t i,
                   Hypotheses& hypotheses);

/// Mean and variance of a Gaussian times a Beta(a, b) share of inliers.
struct BetaFilter {
  double mean = 0;
  double variance = 0;
  double a = 10;
  double b = 10;
};

/// A measurement that is an inlier, N(x, tau2), or uniform over `range` (Vogiatzis & Hernandez,
/// "Video-based, real-time multi-view stereo", IVC 2011, supplement: the moments of the true
/// posterior are matched).
BetaFilter updated(const BetaFilter& prior, double x, double tau2, double range);

}  // namespace vo
