#pragma once

#include "vo/mapping/depth_map_options.h"
#include "vo/mapping/epipolar_search.h"
#include "vo/mapping/hypotheses.h"

namespace vo {

/// The difference of an observation from what its hypothesis predicts, with its variance.
struct Innovation {
  float difference = 0;  ///< 1/m
  float variance = 0;    ///< 1/m^2
};

Innovation innovation(const Observation& observation, std::size_t i, const Hypotheses& hypotheses);

/// Fuses a successful observation into hypothesis i; the first one of a guess replaces the guess.
void fuse(const Observation& observation, const DepthMapOptions& options, std::size_t i,
          Hypotheses& hypotheses);

/// Counts a failed observation of hypothesis i. A hypothesis that fails too often, or fails before
/// it is confirmed, is forgotten: a guess of the given inverse depth, 1/m, takes its place.
void count_failure(const DepthMapOptions& options, float guess, std::size_t i,
                   Hypotheses& hypotheses);

/// The state of a filter: a Gaussian depth and a Beta(a, b) distributed share of inliers.
struct BetaFilter {
  double mean = 0;
  double variance = 0;
  double a = 10;
  double b = 10;
};

/// Returns the state after a measurement x that is either an inlier, N(depth, tau2), or uniform
/// over `range` (Vogiatzis & Hernandez, "Video-based, real-time multi-view stereo", IVC 2011,
/// supplement: the moments of the true posterior are matched).
BetaFilter updated(const BetaFilter& prior, double x, double tau2, double range);

}  // namespace vo
