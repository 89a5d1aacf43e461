#include "synth/truth/truth_channels.h"

#include <algorithm>
#include <cstdio>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/sequence.h"
#include "vo/motion_files/imu_file.h"

namespace synth {
namespace {

bool is_float(TruthChannel channel) {
  return channel == TruthChannel::depth || channel == TruthChannel::normal ||
         channel == TruthChannel::disparity || channel == TruthChannel::depth_beyond;
}

bool is_of_frames(TruthChannel channel) {
  return channel != TruthChannel::velocity && channel != TruthChannel::imu;
}

/// Returns whether a channel requires a next frame, which the last frame lacks.
bool needs_next(TruthChannel channel) {
  return channel == TruthChannel::flow || channel == TruthChannel::occlusion;
}

std::string extension(TruthChannel channel, vo::FloatFormat format) {
  if (is_float(channel)) {
    return std::string(vo::to_string(format));
  }
  return channel == TruthChannel::flow ? "flo" : "png";
}

std::string format_velocities(const CameraPath& path, const vo::Trajectory& trajectory) {
  const TimeSpan span{trajectory.front().timestamp, trajectory.back().timestamp};
  std::string text =
      "#timestamp [s],v_world_x [m s^-1],v_world_y [m s^-1],v_world_z [m s^-1],"
      "w_camera_x [rad s^-1],w_camera_y [rad s^-1],w_camera_z [rad s^-1]\n";
  for (const vo::StampedPose& pose : trajectory) {
    const PathMotion motion = path_motion(path, span, pose.timestamp);
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(), "%.6f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f\n", pose.timestamp,
                  motion.velocity.x(), motion.velocity.y(), motion.velocity.z(),
                  motion.angular_velocity.x(), motion.angular_velocity.y(),
                  motion.angular_velocity.z());
    text += line.data();
  }
  return text;
}

}  // namespace

bool TruthOptions::has(TruthChannel channel) const {
  return std::find(channels.begin(), channels.end(), channel) != channels.end();
}

void TruthOptions::validate() const {
  for (const SurfaceClass& one : classes) {
    one.validate();
  }
  vo::require(!has(TruthChannel::surface_class) || !classes.empty(),
              "channels: class: there are no classes, expected [[class]] with name and patterns");
  edges.validate();
  imu.validate();
  for (const TruthChannel channel : channels) {
    vo::require(!is_of_pair(channel) || stereo_baseline > 0, "channels: ", vo::to_string(channel),
                ": expected a camera with a stereo partner, as a rig has it (edvo render --rig)");
  }
}

bool is_of_pair(TruthChannel channel) {
  return channel == TruthChannel::disparity || channel == TruthChannel::stereo_occlusion;
}

std::vector<TruthChannel> parse_channels(std::string_view text) {
  TruthOptions options;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view name = text.substr(begin, end - begin);
    for (const auto& [channel, channel_name] : enum_names(TruthChannel{})) {
      const bool is_asked_for_by_name = channel == TruthChannel::surface_class ||
                                        channel == TruthChannel::depth_beyond ||
                                        is_of_pair(channel);
      if (name == "all" && !is_asked_for_by_name && !options.has(channel)) {
        options.channels.push_back(channel);
      }
    }
    if (name != "all") {
      const auto channel = vo::parse_enum<TruthChannel>(name);
      vo::require(!options.has(channel), "channels: ", name, " is there twice");
      options.channels.push_back(channel);
    }
    begin = end + 1;
  }
  std::sort(options.channels.begin(), options.channels.end());
  return options.channels;
}

std::string truth_convention(TruthChannel channel, vo::FloatFormat format,
                             const vo::CameraModel& camera) {
  const std::string folder =
      vo::concat("truth/", vo::to_string(channel), "/NNNNNN.", extension(channel, format), ": ");
  switch (channel) {
    case TruthChannel::depth:
      return vo::concat(folder, "float32, m along ",
                        camera.has_optical_axis() ? "the optical axis" : "the ray",
                        " at the pixel's centre, 0 = nothing there");
    case TruthChannel::normal:
      return folder +
             "float32, (x, y, z) of the triangle's unit normal, world axes, towards the camera, "
             "0 = nothing there";
    case TruthChannel::instance:
      return folder + "16 bit, 1 + index of the scene's instance, 0 = nothing there";
    case TruthChannel::material:
      return folder +
             "16 bit, 1 + index of the scene's material, 1 + their number = none given, 0 = "
             "nothing there";
    case TruthChannel::surface_class:
      return folder + "16 bit, id of a class in truth/labels.json, 0 = none, or nothing there";
    case TruthChannel::flow:
      return vo::concat(
          folder,
          "Middlebury, float32 (du, dv) px from this frame's pixel centre to its point in the "
          "next frame, u right, v down, ",
          camera.wraps() ? "du by the shorter way round, " : "",
          "above 1e9 = unknown; the last frame has none");
    case TruthChannel::occlusion:
      return folder +
             "8 bit, the pixel's point is 0 = visible in the next frame, 255 = hidden there, 128 = "
             "outside its image, 64 = nothing there; the last frame has none";
    case TruthChannel::edges:
      return folder + "8 bit, sum of 1 = depth edge, 2 = crease, 4 = albedo, 8 = shadow";
    case TruthChannel::moving:
      return folder +
             "8 bit, 255 = the pixel's point is elsewhere in the world at the next frame (of the "
             "last: at the one before)";
    case TruthChannel::velocity:
      return "truth/velocity.csv: s, m/s in the world, rad/s in the camera's axes";
    case TruthChannel::imu:
      return "imu.csv: EuRoC, ns, rad/s, m/s^2 (acceleration less gravity), camera's axes, at the "
             "camera; imu.toml: its noise; truth/imu_states.csv: EuRoC, T_world_camera, quaternion "
             "w first, velocity "
             "in the world, biases";
    case TruthChannel::disparity:
      return folder +
             "float32, px, column in this image less that in the partner's, to the right: fx times "
             "truth.stereo_baseline over the depth, 0 = nothing there";
    case TruthChannel::stereo_occlusion:
      return folder +
             "8 bit, the pixel's point is 0 = visible to the partner, 255 = hidden from it, 128 = "
             "outside its image, 64 = nothing there";
    case TruthChannel::depth_beyond:
      return folder +
             "float32, m, as depth, of the first surface that is neither smooth glass, seen "
             "straight through, nor a mirror, along the way that light takes, 0 = nothing there";
  }
  return "";
}

std::vector<TruthFile> truth_files(const TruthOptions& options, std::size_t index,
                                   std::size_t frames) {
  std::vector<TruthFile> files;
  for (const TruthChannel channel : options.channels) {
    if (is_of_frames(channel) && !(needs_next(channel) && index + 1 == frames)) {
      files.push_back({channel, vo::frame_file("truth/" + std::string(vo::to_string(channel)),
                                               index, extension(channel, options.float_format))});
    }
  }
  return files;
}

std::vector<vo::NamedBytes> encode_imu(const vo::ImuRecord& record) {
  return {{"imu.csv", vo::format_imu(record.samples)},
          {"imu.toml", vo::format_imu_noise(record.noise)},
          {"truth/imu_states.csv", vo::format_states(record.states)}};
}

std::vector<vo::NamedBytes> encode_motion(const TruthOptions& options, const CameraPath& path,
                                          const vo::Trajectory& trajectory) {
  std::vector<vo::NamedBytes> files;
  if (options.has(TruthChannel::velocity)) {
    files.push_back({"truth/velocity.csv", format_velocities(path, trajectory)});
  }
  if (options.has(TruthChannel::imu)) {
    const vo::ImuRecord record =
        measure_imu(path, {trajectory.front().timestamp, trajectory.back().timestamp}, options.imu);
    const std::vector<vo::NamedBytes> of_imu = encode_imu(record);
    files.insert(files.end(), of_imu.begin(), of_imu.end());
  }
  return files;
}

}  // namespace synth
