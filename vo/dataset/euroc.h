#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "vo/dataset/sequence_source.h"
#include "vo/files/output.h"

namespace vo {

/// Opens a sequence in the layout of the EuRoC MAV data set (Burri et al., IJRR 2016), called ASL:
///     mav0/cam0/{data.csv, sensor.yaml, data/<ns>.png}
///     mav0/imu0/{data.csv, sensor.yaml}
///     mav0/state_groundtruth_estimate0/{data.csv, sensor.yaml}
/// The data set has no depth; this project adds mav0/depth0/, laid out as cam0: 16 bit, planar, the
/// units per metre in its sensor.yaml, as many lines as cam0, whose stamps may differ. Stamps are
/// nanoseconds, quaternions have w first. The ground truth is of the body; T_BS in sensor.yaml is
/// T_body_sensor. Its world has z up, unless `world_up: y` in the ground truth's sensor.yaml, this
/// project's addition, says otherwise.
SequenceSource open_euroc(const std::filesystem::path& folder,
                          const std::optional<RgbdCamera>& camera);

/// Encodes a frame's image and, if it has depth, its depth image as files of camera `number`.
std::vector<NamedBytes> encode_euroc_frame(const RgbdCamera& camera, const RgbdFrame& frame,
                                           std::size_t number = 0);

/// Encodes the files of camera `number` but the images; a lens of Kannala and Brandt is written as
/// `equidistant`. Throws Error for one of Brown and Conrady with k3 to k6, which the format cannot
/// hold. `depth_stamps`, s, are those of the frames' depth, none where there is no depth.
std::vector<NamedBytes> encode_euroc_camera(const SequenceSource& source,
                                            const std::vector<double>& depth_stamps,
                                            std::size_t number = 0);

/// Encodes the files of the body: ground truth and IMU, as far as the source has them.
std::vector<NamedBytes> encode_euroc_body(const SequenceSource& source, const SE3& T_body_imu = {});

/// Encodes all files but the images of a sequence of one camera.
std::vector<NamedBytes> encode_euroc_lists(const SequenceSource& source,
                                           const std::vector<double>& depth_stamps);

}  // namespace vo
