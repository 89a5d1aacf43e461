#pragma once

#include <filesystem>
#include <optional>

#include "tools/laboratory/outside_tracker.h"
#include "tools/laboratory/results.h"
#include "tools/pictures/frame_gallery.h"
#include "tools/processes/file_lock.h"
#include "tools/scenario/scenario.h"

namespace tools {

struct TrialSettings {
  std::filesystem::path cache;
  std::optional<OutsideTracker> tracker;   ///< ours where there is none
  bool measure_again = false;              ///< what this program has measured before
  std::optional<GalleryOptions> pictures;  ///< seed 0 is reported with these
};

/// Renders what the cache does not hold, tracks and measures. What our own tracker has measured is
/// kept in the cache under the hash of the program, the tracker's options and the sequence's bytes;
/// the next run takes it from there, but for a seed that is reported. Whatever makes this
/// impossible is the result's `problem`; nothing but what `waiting` throws ends it.
TrialResult run_trial(const Scenario& scenario, int seed, const TrialSettings& settings,
                      const WaitObserver& waiting);

}  // namespace tools
