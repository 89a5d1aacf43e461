#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "vo/geometry/imu.h"

namespace vo {

/// Returns the samples as EuRoC's imu0/data.csv: ns, angular velocity, specific force.
std::string format_imu(const std::vector<ImuSample>& samples);
std::vector<ImuSample> read_imu(const std::filesystem::path& path);

/// Returns the noise densities as imu.toml, a format of this project.
std::string format_imu_noise(const ImuNoise& noise);
ImuNoise read_imu_noise(const std::filesystem::path& path);

/// Returns the states as EuRoC's state_groundtruth_estimate0/data.csv: ns, position, quaternion (w
/// first), velocity, gyroscope bias, accelerometer bias.
std::string format_states(const std::vector<BodyState>& states);

/// Reads what `format_states` writes. Throws Error naming file and line if a line is malformed.
std::vector<BodyState> read_states(const std::filesystem::path& path);

}  // namespace vo
