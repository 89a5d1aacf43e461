#include "synth/sensor/pinhole_effects.h"

#include <array>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"

namespace synth {

void require_pinhole_effects(const SensorOptions& options, const vo::CameraModel& camera) {
  const DepthSensorOptions& depth = options.depth;
  const LateralNoise& lateral = depth.lateral;
  const DepthHoles& holes = depth.holes;
  const std::array<std::pair<const char*, bool>, 14> effects{{
      {"lens.blur", options.lens.blur > 0},
      {"lens.vignetting", !options.lens.vignetting.is_zero()},
      {"depth.offset", !depth.offset.isZero(0)},
      {"depth.turn", !depth.turn.isZero(0)},
      {"depth.normal", depth.normal.sigma > 0 || depth.normal.grazing > 0},
      {"depth.lateral", lateral.sigma > 0 || lateral.grazing > 0},
      {"depth.axial.correlation", depth.axial.is_on() && depth.axial.correlation > 0},
      {"depth.disparity", depth.disparity.focal_baseline > 0},
      {"depth.flying", depth.flying.share > 0},
      {"depth.holes.second_view", holes.second_view != 0},
      {"depth.holes.max_step", holes.max_step > 0},
      {"depth.holes.edge_loss", holes.edge_loss > 0},
      {"depth.holes.correlation", holes.max_incidence_deg < 90 && holes.correlation > 0},
      {"depth.multipath.radius", depth.multipath.is_on() && depth.multipath.radius > 0},
  }};
  for (const auto& [name, is_on] : effects) {
    vo::require(!is_on || camera.pinhole() != nullptr, "sensor.", name,
                ": is for pinhole cameras, expected it off for projection = \"",
                vo::to_string(camera.projection()), "\"");
  }
}

}  // namespace synth
