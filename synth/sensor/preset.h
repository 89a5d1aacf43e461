#pragma once

#include "synth/sensor/sensor.h"

namespace synth {

/// Returns the options of a preset; docs/sensors.md gives the source of each number.
SensorOptions preset_options(SensorPreset preset);

}  // namespace synth
