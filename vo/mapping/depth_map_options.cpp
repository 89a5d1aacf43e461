#include "vo/mapping/depth_map_options.h"

#include "vo/core/error.h"

namespace vo {

void EpipolarOptions::validate() const {
  require(sigma_offset_px >= 0 && sigma_line_px >= 0 && sigma_match_px > 0 && sigma_grey >= 0,
          "epipolar: expected sigma_match_px above 0 and the other sigmas at least 0");
}

void HostOptions::validate() const {
  require(every >= 0, "host.every: expected at least 0, got ", every);
  require(max_flow > 0, "host.max_flow: expected above 0, got ", max_flow);
}

void DepthMapOptions::validate() const {
  require(max_hypotheses >= 0, "depth_map.max_hypotheses: expected at least 0, got ",
          max_hypotheses);
  require(min_depth > 0 && max_depth > min_depth,
          "depth_map: expected 0 < min_depth < max_depth, got ", min_depth, " and ", max_depth);
  require(gate_sigmas > 0, "depth_map.gate_sigmas: expected above 0, got ", gate_sigmas);
  host.validate();
  epipolar.validate();
}

}  // namespace vo
