#include "vo/mapping/depth_map_options.h"

#include "vo/core/error.h"

namespace vo {

void EpipolarOptions::validate() const {
  require(search_sigmas > 0 && max_search_px > 1,
          "epipolar: expected search_sigmas above 0 and max_search_px above 1");
  require(min_parallax_px > 0, "epipolar.min_parallax_px: expected above 0, got ", min_parallax_px);
  require(min_gradient > 0, "epipolar.min_gradient: expected above 0, got ", min_gradient);
  require(min_cos2 > 0 && min_cos2 < 1, "epipolar.min_cos2: expected 0 to 1, got ", min_cos2);
  require(max_scale_change > 1, "epipolar.max_scale_change: expected above 1, got ",
          max_scale_change);
  require(max_residual > 0, "epipolar.max_residual: expected above 0, got ", max_residual);
  require(ambiguity >= 1, "epipolar.ambiguity: expected at least 1, got ", ambiguity);
  require(sigma_offset_px >= 0 && sigma_line_px >= 0 && sigma_match_px > 0 && sigma_grey >= 0,
          "epipolar: expected sigma_match_px above 0 and the other sigmas at least 0");
}

void HostOptions::validate() const {
  require(every >= 0, "host.every: expected at least 0, got ", every);
  require(max_flow > 0 && min_overlap >= 0 && min_overlap <= 1,
          "host: expected max_flow above 0 and min_overlap from 0 to 1");
}

void DepthMapOptions::validate() const {
  require(max_hypotheses >= 0, "depth_map.max_hypotheses: expected at least 0, got ",
          max_hypotheses);
  require(min_depth > 0 && max_depth > min_depth,
          "depth_map: expected 0 < min_depth < max_depth, got ", min_depth, " and ", max_depth);
  require(gate_sigmas > 0, "depth_map.gate_sigmas: expected above 0, got ", gate_sigmas);
  require(min_sigma > 0 && propagation_sigma >= 0 && fill_sigma > 0,
          "depth_map: expected min_sigma and fill_sigma above 0, propagation_sigma at least 0");
  require(confident_sigma > min_sigma, "depth_map.confident_sigma: expected above min_sigma, got ",
          confident_sigma);
  require(max_failures >= 1, "depth_map.max_failures: expected at least 1, got ", max_failures);
  host.validate();
  epipolar.validate();
}

}  // namespace vo
