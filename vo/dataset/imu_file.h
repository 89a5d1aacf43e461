#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "vo/geometry/imu.h"

namespace vo {

/// Whole nanoseconds, as EuRoC's files have them.
std::int64_t to_nanoseconds(double seconds);

/// EuRoC's imu0/data.csv: ns, angular velocity, specific force.
std::string format_imu(const std::vector<ImuSample>& samples);
std::vector<ImuSample> read_imu(const std::filesystem::path& path);

/// imu.toml, which is ours.
std::string format_imu_noise(const ImuNoise& noise);
ImuNoise read_imu_noise(const std::filesystem::path& path);

/// EuRoC's state_groundtruth_estimate0/data.csv: ns, position, quaternion (w first), velocity,
/// gyroscope bias, accelerometer bias.
std::string format_states(const std::vector<BodyState>& states);

/// Throws Error naming file and line.
std::vector<BodyState> read_states(const std::filesystem::path& path);

}  // namespace vo
