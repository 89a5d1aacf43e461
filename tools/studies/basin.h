#pragma once

#include "tools/studies/clip.h"
#include "tools/studies/study.h"
#include "vo/core/progress.h"

namespace tools {

struct BasinSettings {
  vo::TrackerOptions tracker;
  int pairs = 12;                ///< number of frame pairs that are aligned
  int apart = 1;                 ///< distance between the two frames of a pair, frames
  int steps = 7;                 ///< number of values of each offset, 0 included
  double max_translation = 0.3;  ///< greatest translational offset, m
  double max_rotation_deg = 12;  ///< greatest rotational offset, deg
  double max_error = 0.01;       ///< greatest error of an alignment that counts as converged, m
  double max_error_deg = 0.3;    ///< greatest error of an alignment that counts as converged, deg
  int jobs = 1;

  void validate() const;  ///< throws vo::Error on an invalid setting
};

template <typename Visitor>
void visit_fields(Visitor& visit, BasinSettings& settings) {
  visit("pairs", settings.pairs, "of frames that are aligned, each in another direction");
  visit("apart", settings.apart, "frames between the two of a pair");
  visit("steps", settings.steps, "of each offset, none included");
  visit("max_translation", settings.max_translation, "greatest offset, m");
  visit("max_rotation_deg", settings.max_rotation_deg, "greatest offset, deg");
  visit("max_error", settings.max_error, "of an alignment that converged, m");
  visit("max_error_deg", settings.max_error_deg, "of an alignment that converged, deg");
}

/// Measures the basin of convergence: frame pairs are aligned from the true pose displaced by
/// growing translations and rotations, each pair in directions of its own.
StudyReport study_basin(const Clip& clip, const BasinSettings& settings,
                        const vo::Progress& progress);

}  // namespace tools
