#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// The layout of the EuRoC MAV data set (Burri et al., IJRR 2016), also called ASL:
///     mav0/cam0/{data.csv, sensor.yaml, data/<ns>.png}
///     mav0/imu0/{data.csv, sensor.yaml}
///     mav0/state_groundtruth_estimate0/{data.csv, sensor.yaml}
/// and, as it has no depth, ours beside it: mav0/depth0/ as cam0, 16 bit, planar, the units per
/// metre in its sensor.yaml. Stamps are nanoseconds, quaternions have w first. The ground truth is
/// of the body; T_BS in sensor.yaml is T_body_sensor.
SequenceSource open_euroc(const std::filesystem::path& folder,
                          const std::optional<RgbdCamera>& camera);

/// A frame's files.
std::vector<NamedBytes> encode_euroc_frame(const RgbdCamera& camera, const RgbdFrame& frame);

/// All other files; a lens of Kannala and Brandt is written as `equidistant`. Throws Error for one
/// of Brown and Conrady with k3, which the format cannot hold.
std::vector<NamedBytes> encode_euroc_lists(const SequenceSource& source, bool has_depth);

}  // namespace vo
