#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/laboratory/results.h"
#include "tools/outside_tracker/outside_tracker.h"
#include "tools/pictures/frame_gallery.h"
#include "tools/scenario/scenario.h"
#include "vo/core/progress.h"

namespace tools {

struct TrialSettings {
  std::filesystem::path cache;
  std::optional<OutsideTracker> tracker;   ///< external tracker; edvo's own if empty
  bool measure_again = false;              ///< ignores results in the cache
  std::optional<GalleryOptions> pictures;  ///< if set, seed 0 gets a report with pictures
};

/// Returns the hash of this program's file, because another build may measure differently. The file
/// is read at the first call.
const std::string& program_hash();

/// Renders the sequence unless the cache holds it, tracks it and measures. Results of edvo's own
/// tracker are cached under the hash of the program, the tracker's options and the sequence's bytes
/// and reused, except for a seed that is reported. An error becomes the result's `problem`; only
/// exceptions thrown by `waiting` propagate.
TrialResult run_trial(const Scenario& scenario, int seed, const TrialSettings& settings,
                      const vo::WaitObserver& waiting);

}  // namespace tools
