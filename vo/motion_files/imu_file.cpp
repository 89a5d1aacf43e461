#include "vo/motion_files/imu_file.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"
#include "vo/text_files/toml_file.h"

namespace vo {
namespace {

constexpr std::size_t kImuValues = 7;
constexpr std::size_t kStateValues = 17;

void add_values(std::string& line, const Eigen::Vector3d& values) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), ",%.12g,%.12g,%.12g", values.x(), values.y(), values.z());
  line += text.data();
}

/// Returns the numbers of a line, its stamp converted from ns to s. Throws Error for a stamp beyond
/// what `parse_nanoseconds` takes.
std::vector<double> parse_line(const TextLine& line, std::size_t count) {
  require(line.fields.size() == count, line.place(), ": expected ", count, " values, got ",
          line.fields.size());
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(parse_number(line, i));
  }
  values[0] = parse_nanoseconds(line, 0);
  return values;
}

Eigen::Vector3d vector_at(const std::vector<double>& values, std::size_t first) {
  return {values[first], values[first + 1], values[first + 2]};
}

}  // namespace

std::string format_imu(const std::vector<ImuSample>& samples) {
  std::string text =
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
      "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n";
  for (const ImuSample& sample : samples) {
    text += std::to_string(to_nanoseconds(sample.timestamp));
    add_values(text, sample.angular_velocity);
    add_values(text, sample.specific_force);
    text += "\n";
  }
  return text;
}

std::vector<ImuSample> read_imu(const std::filesystem::path& path) {
  std::vector<ImuSample> samples;
  TextFile(path).for_each_line([&](const TextLine& line) {
    const std::vector<double> values = parse_line(line, kImuValues);
    samples.push_back({values[0], vector_at(values, 1), vector_at(values, 4)});
  });
  return samples;
}

std::string format_imu_noise(const ImuNoise& noise) {
  ImuNoise copy = noise;
  return format_toml(fields_of(copy));
}

ImuNoise read_imu_noise(const std::filesystem::path& path) {
  ImuNoise noise;
  std::vector<Field> fields = fields_of(noise);
  assign_fields(read_toml(path), fields);
  return noise;
}

std::string format_states(const std::vector<BodyState>& states) {
  std::string text =
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],"
      "q_RS_z [],v_RS_R_x [m s^-1],v_RS_R_y [m s^-1],v_RS_R_z [m s^-1],b_w_RS_S_x [rad s^-1],"
      "b_w_RS_S_y [rad s^-1],b_w_RS_S_z [rad s^-1],b_a_RS_S_x [m s^-2],b_a_RS_S_y [m s^-2],"
      "b_a_RS_S_z [m s^-2]\n";
  for (const BodyState& state : states) {
    text += format_euroc_pose({state.timestamp, state.T_world_body});
    add_values(text, state.velocity);
    add_values(text, state.gyro_bias);
    add_values(text, state.accel_bias);
    text += "\n";
  }
  return text;
}

std::vector<BodyState> read_states(const std::filesystem::path& path) {
  std::vector<BodyState> states;
  TextFile(path).for_each_line([&](const TextLine& line) {
    const std::vector<double> v = parse_line(line, kStateValues);
    const SE3 T_world_body = checked_pose(line.place(), {v[4], v[5], v[6], v[7]}, vector_at(v, 1));
    states.push_back({v[0], T_world_body, vector_at(v, 8), vector_at(v, 11), vector_at(v, 14)});
  });
  return states;
}

}  // namespace vo
