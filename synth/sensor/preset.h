#pragma once

#include "synth/sensor/sensor.h"

namespace synth {

/// The options that a preset stands for: docs/sensors.md says where each number is from.
SensorOptions preset_options(SensorPreset preset);

}  // namespace synth
