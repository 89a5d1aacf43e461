#pragma once

#include <cstdint>

#include "tools/datasets/spec.h"

namespace tools {

/// Reads the rig that a spec names with `rig`, its file in the spec's folder unless its path is
/// absolute, into `spec.rig`; nothing where it names none. Throws vo::Error with file:line for a
/// rig that cannot be read, and for keys and formats that do not go with it: cameras of the spec's
/// own, formats of one camera, options of a sensor of which every camera's preset leaves nothing,
/// and several seeds where a camera's noise has a seed of its own.
void read_spec_rig(DatasetSpec& spec);

/// Throws vo::Error where the cameras of the rig cannot be rendered with the sensors and the
/// channels of the spec's sequences, as `synth::camera_jobs` says.
void require_usable_rig(const DatasetSpec& spec);

/// Returns what a sequence's number of seed adds to the seed of its sensor: numbers that differ by
/// as much as the rig has cameras, each of which takes the one after that of the camera before it.
std::uint64_t sensor_seed_offset(const DatasetSpec& spec, int seed);

}  // namespace tools
