#include "vo/odometry/mono_options.h"

#include "vo/core/error.h"

namespace vo {

void MonoOptions::validate() const {
  require(start_depth > 0, "mono.start_depth: expected above 0, got ", start_depth);
  require(max_lost_frames >= 1, "mono.max_lost_frames: expected at least 1, got ", max_lost_frames);
  require(wanted_parallax_px >= kMinStartParallaxPx, "mono.wanted_parallax_px: expected at least ",
          kMinStartParallaxPx, ", got ", wanted_parallax_px);
  require(!tracker.symmetric,
          "mono.symmetric: expected false, the current frame's points have no depth of their own");
  require(!tracker.doubt,
          "mono.doubt: expected false, poses on a map are judged by its scale and its edges");
  require(tracker.points.source == EdgeSource::reference &&
              tracker.points.selection == PointSelection::edges,
          "mono.points: expected source = reference and selection = edges, the map's points");
  require(tracker.align.max_depth_ratio == 0,
          "mono.align.max_depth_ratio: expected 0, there is no current depth to test against");
  tracker.validate();
  map.validate();
}

MonoOptions mono_options() {
  MonoOptions options;
  options.tracker = preset_options(TrackerPreset::best_measured);
  options.tracker.symmetric = false;
  options.tracker.doubt = false;
  options.tracker.points.min_depth = 1e-3;
  options.tracker.points.max_depth = 1e3;
  options.tracker.points.coarser_share = 0.7;
  options.tracker.points.discontinuity_radius = 0;
  options.tracker.align.depth_noise = 1;
  options.tracker.align.min_translation = 5e-5;  // finer steps than depths of a map are worth
  options.tracker.align.min_rotation_deg = 2e-3;
  options.tracker.align.step_limit_growth = 2;
  options.tracker.align.last_step = 1;
  options.tracker.align.secant = false;
  options.tracker.align.coarse_references = 0;
  options.tracker.map.references = 6;
  return options;
}

}  // namespace vo
