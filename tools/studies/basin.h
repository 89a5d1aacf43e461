#pragma once

#include "tools/studies/clip.h"
#include "tools/studies/study.h"
#include "vo/core/progress.h"

namespace tools {

struct BasinSettings {
  vo::TrackerOptions tracker;
  int pairs = 12;                ///< of frames that are aligned
  int apart = 1;                 ///< frames between the two of a pair
  int steps = 7;                 ///< of each offset, 0 included
  double max_translation = 0.3;  ///< m, greatest offset
  double max_rotation_deg = 12;  ///< deg, greatest offset
  double max_error = 0.01;       ///< m, of an alignment that converged
  double max_error_deg = 0.3;    ///< deg, of an alignment that converged
  int jobs = 1;

  void validate() const;  ///< throws vo::Error
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

/// From how far off the truth an alignment finds it: pairs of frames aligned from the true pose
/// moved and turned by growing offsets, each pair in a direction of its own.
StudyReport study_basin(const Clip& clip, const BasinSettings& settings,
                        const vo::Progress& progress);

}  // namespace tools
