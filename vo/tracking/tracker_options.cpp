#include "vo/tracking/tracker_options.h"

#include "vo/core/error.h"

namespace vo {

void KeyframeOptions::validate() const {
  require(every >= 0, "keyframes.every: expected at least 0, got ", every);
  require(max_flow > 0, "keyframes.max_flow: expected above 0, got ", max_flow);
  require(min_sharpness >= 0 && min_sharpness <= 1,
          "keyframes.min_sharpness: expected 0 to 1, got ", min_sharpness);
}

void LostOptions::validate() const {
  require(min_correlation >= -1 && min_correlation <= 1,
          "lost.min_correlation: expected -1 to 1, got ", min_correlation);
  require(min_depth_agreement >= 0 && min_depth_agreement <= 1,
          "lost.min_depth_agreement: expected 0 to 1, got ", min_depth_agreement);
}

void TrackerOptions::validate() const {
  pyramid.validate();
  edges.validate();
  points.validate();
  align.validate();
  keyframes.validate();
  map.validate();
  window.validate();
  lost.validate();
}

TrackerOptions TrackerOptions::starting_from(const RgbdCamera& camera) const {
  TrackerOptions options = *this;
  if (shutter == ShutterModel::estimated && !align.readout.is_rolling()) {
    options.align.readout = camera.readout;
  }
  if (!points.depth_noise.is_known()) {
    options.points.depth_noise = camera.depth_noise;
  }
  return options;
}

}  // namespace vo
