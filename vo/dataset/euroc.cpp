#include "vo/dataset/euroc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_images.h"
#include "vo/files/input.h"
#include "vo/frames/depth_timestamp.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCameras = "mav0/cam";
constexpr const char* kDepths = "mav0/depth";
constexpr const char* kCamera = "mav0/cam0";
constexpr const char* kDepth = "mav0/depth0";
constexpr const char* kImu = "mav0/imu0";
constexpr const char* kTruth = "mav0/state_groundtruth_estimate0";

/// Returns the value of `key: value` or of `key: [...]` over several lines; empty if absent.
std::string yaml_value(const std::string& text, const std::string& key) {
  std::size_t at = text.starts_with(key + ":") ? 0 : text.find("\n" + key + ":");
  if (at == std::string::npos) {
    at = text.find(" " + key + ":");
  }
  if (at == std::string::npos) {
    return "";
  }
  const std::size_t begin = text.find(':', at) + 1;
  const std::size_t line_end = std::min(text.find('\n', begin), text.size());
  const std::size_t value_end = std::min(text.find('#', begin), line_end);
  const std::size_t bracket = text.find('[', begin);
  if (bracket > value_end) {
    return text.substr(begin, value_end - begin);
  }
  return text.substr(bracket + 1, text.find(']', bracket) - bracket - 1);
}

std::vector<double> yaml_numbers(const fs::path& path, const std::string& text,
                                 const std::string& key, std::size_t count) {
  try {
    std::string value = yaml_value(text, key);
    std::replace(value.begin(), value.end(), '\n', ' ');
    return parse_reals(value, count);
  } catch (const Error& error) {
    fail(path.string(), ": ", key, ": ", error.what());
  }
}

/// Returns the image's size, px, as `resolution` gives it.
cv::Size read_resolution(const fs::path& path, const std::string& text) {
  constexpr double kMaxSize = 16384;
  const std::vector<double> size = yaml_numbers(path, text, "resolution", 2);
  for (const double length : size) {
    require(length >= 1 && length <= kMaxSize && length == std::floor(length), path.string(),
            ": resolution: expected whole numbers from 1 to ", kMaxSize, ", got ", length);
  }
  return {static_cast<int>(size[0]), static_cast<int>(size[1])};
}

RgbdCamera read_sensor(const fs::path& path, const std::string& text) {
  const cv::Size size = read_resolution(path, text);
  const std::vector<double> k = yaml_numbers(path, text, "intrinsics", 4);
  const std::vector<double> d = yaml_numbers(path, text, "distortion_coefficients", 4);
  const std::string model = yaml_value(text, "distortion_model");
  const bool is_fisheye = model.find("equidistant") != std::string::npos;
  require(is_fisheye || model.find("radial-tangential") != std::string::npos ||
              model.find("radtan") != std::string::npos,
          path.string(),
          ": distortion_model: expected radial-tangential, radtan or equidistant, got", model);
  RgbdCamera camera{{size.width, size.height, k[0], k[1], k[2], k[3]}};
  camera.pinhole.distortion = is_fisheye
                                  ? Distortion{.k1 = d[0],
                                               .k2 = d[1],
                                               .k3 = d[2],
                                               .k4 = d[3],
                                               .model = DistortionModel::kannala_brandt}
                                  : Distortion{.k1 = d[0], .k2 = d[1], .p1 = d[2], .p2 = d[3]};
  return checked_camera(camera, path);
}

SE3 read_extrinsics(const fs::path& path, const std::string& text) {
  const std::size_t block = text.find("T_BS:");
  require(block != std::string::npos, path.string(), ": expected T_BS");
  const std::vector<double> m = yaml_numbers(path, text.substr(block), "data", 16);
  return checked_pose(path.string() + ": T_BS",
                      Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(m.data()));
}

/// Returns the axis of the world that points up: the data set's own z, unless this project's
/// addition names another.
WorldUp read_up(const fs::path& path) {
  std::string up = fs::exists(path)
                       ? yaml_value(read_file(path, kMaxConfigurationBytes), "world_up")
                       : std::string();
  std::erase(up, ' ');
  try {
    return up.empty() ? WorldUp::z : parse_enum<WorldUp>(up);
  } catch (const Error& error) {
    fail(path.string(), ": world_up: ", error.what());
  }
}

struct StampedFile {
  std::int64_t nanoseconds = 0;
  fs::path path;
};

/// Returns the line's first field, a whole number of nanoseconds.
std::int64_t stamp_of(const TextLine& line) {
  try {
    return parse_integer(line.fields[0]);
  } catch (const Error& error) {
    fail(line.place(), ": ", error.what());
  }
}

std::vector<StampedFile> read_list(const fs::path& folder) {
  std::vector<StampedFile> files;
  TextFile(folder / "data.csv").for_each_line([&](const TextLine& line) {
    require(line.fields.size() == 2, line.place(), ": expected `timestamp,filename`, got ",
            line.fields.size(), " values");
    files.push_back(
        {stamp_of(line), path_in(folder / "data", std::string(line.fields[1]), line.place())});
    require(files.size() < 2 || files.back().nanoseconds > files[files.size() - 2].nanoseconds,
            line.place(), ": expected a stamp after the one before it");
  });
  require(!files.empty(), (folder / "data.csv").string(), ": lists no images");
  return files;
}

std::string format_matrix(const SE3& T) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = T.rotation_matrix();
  matrix.topRightCorner<3, 1>() = T.translation();
  std::string text = "T_BS:\n  cols: 4\n  rows: 4\n  data: [";
  for (int i = 0; i < 16; ++i) {
    text += (i == 0 ? "" : ", ") + format_real(matrix(i / 4, i % 4));
  }
  return text + "]\n";
}

std::string format_lens(const Distortion& lens) {
  const bool is_fisheye = lens.model == DistortionModel::kannala_brandt;
  const std::array<double, 4> coefficients = is_fisheye
                                                 ? std::array{lens.k1, lens.k2, lens.k3, lens.k4}
                                                 : std::array{lens.k1, lens.k2, lens.p1, lens.p2};
  std::string text = is_fisheye ? "distortion_model: equidistant\ndistortion_coefficients: ["
                                : "distortion_model: radial-tangential\ndistortion_coefficients: [";
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    text += (i == 0 ? "" : ", ") + format_real(coefficients[i]);
  }
  return text + "]\n";
}

std::string format_sensor(const SequenceSource& source, const char* comment) {
  const PinholeCamera& camera = source.camera.pinhole;
  const double span = source.timestamps.back() - source.timestamps.front();
  const double rate = span > 0 ? static_cast<double>(source.timestamps.size() - 1) / span : 0;
  return concat("#Default camera model\nsensor_type: camera\ncomment: ", comment, "\n",
                format_matrix(source.T_body_camera), "rate_hz: ", format_real(rate),
                "\nresolution: [", camera.width, ", ", camera.height,
                "]\ncamera_model: pinhole\nintrinsics: [", format_real(camera.fx), ", ",
                format_real(camera.fy), ", ", format_real(camera.cx), ", ", format_real(camera.cy),
                "] #fu, fv, cu, cv\n", format_lens(camera.distortion));
}

/// EuRoC's name and unit of a noise density.
struct NoiseKey {
  const char* key;
  const char* unit;
  double ImuNoise::*value;
};

constexpr std::array kNoiseKeys = {
    NoiseKey{"rate_hz", "Hz", &ImuNoise::rate},
    NoiseKey{"gyroscope_noise_density", "rad/s/sqrt(Hz)", &ImuNoise::gyro_noise},
    NoiseKey{"gyroscope_random_walk", "rad/s^2/sqrt(Hz)", &ImuNoise::gyro_bias_walk},
    NoiseKey{"accelerometer_noise_density", "m/s^2/sqrt(Hz)", &ImuNoise::accel_noise},
    NoiseKey{"accelerometer_random_walk", "m/s^3/sqrt(Hz)", &ImuNoise::accel_bias_walk}};

std::string format_imu_sensor(const ImuNoise& noise, const SE3& T_body_imu) {
  std::string text = "#Default imu sensor yaml file\nsensor_type: imu\ncomment: body\n" +
                     format_matrix(T_body_imu);
  for (const NoiseKey& key : kNoiseKeys) {
    text += concat(key.key, ": ", format_real(noise.*key.value), " # [", key.unit, "]\n");
  }
  return text;
}

/// Reads an IMU's noise densities; those that the file does not give are 0, unknown.
ImuNoise read_imu_sensor(const fs::path& path) {
  ImuNoise noise;
  if (!fs::exists(path)) {
    return noise;
  }
  const std::string text = read_file(path);
  for (const NoiseKey& key : kNoiseKeys) {
    if (!yaml_value(text, key.key).empty()) {
      noise.*key.value = yaml_numbers(path, text, key.key, 1)[0];
    }
  }
  return noise;
}

/// Returns the folder of a camera's images or depth.
std::string folder_of(const char* kind, std::size_t number) {
  return concat(kind, number);
}

/// Returns an image's file within the folder of its camera.
std::string image_name(double timestamp) {
  return concat("/data/", to_nanoseconds(timestamp), ".png");
}

std::string format_list(const std::vector<double>& timestamps) {
  std::string text = "#timestamp [ns],filename\n";
  for (const double timestamp : timestamps) {
    const std::string ns = std::to_string(to_nanoseconds(timestamp));
    text += concat(ns, ",", ns, ".png\n");
  }
  return text;
}

/// Returns the ground truth as data.csv: the states of the IMU if there are any, else the body's
/// poses.
std::string format_truth(const SequenceSource& source) {
  if (!source.imu.states.empty()) {
    return format_states(source.imu.states);
  }
  const SE3 T_camera_body = source.T_body_camera.inverse();
  Trajectory body = source.truth;
  for (StampedPose& pose : body) {
    pose.T_world_camera = pose.T_world_camera * T_camera_body;
  }
  return format_euroc_trajectory(body);
}

}  // namespace

SequenceSource open_euroc(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  const fs::path sensor = folder / kCamera / "sensor.yaml";
  SequenceSource source;
  const std::string text = read_file(sensor, kMaxConfigurationBytes);
  source.camera = camera ? *camera : read_sensor(sensor, text);
  source.T_body_camera = read_extrinsics(sensor, text);
  const auto images = std::make_shared<const std::vector<StampedFile>>(read_list(folder / kCamera));
  for (const StampedFile& image : *images) {
    source.timestamps.push_back(seconds_of(image.nanoseconds));
  }
  const auto depths = std::make_shared<std::vector<StampedFile>>();
  if (fs::exists(folder / kDepth / "data.csv")) {
    *depths = read_list(folder / kDepth);
    require(depths->size() == images->size(), (folder / kDepth / "data.csv").string(), ": lists ",
            depths->size(), " depth images, expected as many as the ", images->size(),
            " images of cam0");
    const fs::path path = folder / kDepth / "sensor.yaml";
    source.camera.depth_units_per_m =
        yaml_numbers(path, read_file(path, kMaxConfigurationBytes), "depth_units_per_m", 1)[0];
    checked_camera(source.camera, path);
  }
  source.read = [=, camera = source.camera, timestamps = source.timestamps](std::size_t index) {
    const StampedFile& image = images->at(index);
    RgbdFrame frame{timestamps[index], read_frame_image(image.path, camera.pinhole), {}};
    if (!depths->empty()) {
      const StampedFile& depth = depths->at(index);
      frame.depth = read_depth_png(depth.path, camera);
      frame.depth_delay = seconds_of(depth.nanoseconds) - frame.timestamp;
    }
    return frame;
  };
  source.up = read_up(folder / kTruth / "sensor.yaml");
  if (fs::exists(folder / kTruth / "data.csv")) {
    source.truth = read_truth(folder / kTruth / "data.csv", TrajectoryFormat::euroc, source.notes);
    for (StampedPose& pose : source.truth) {
      pose.T_world_camera = pose.T_world_camera * source.T_body_camera;
    }
  }
  if (fs::exists(folder / kImu / "data.csv")) {
    source.imu.samples = read_imu(folder / kImu / "data.csv");
    source.imu.noise = read_imu_sensor(folder / kImu / "sensor.yaml");
    source.imu.states = read_states(folder / kTruth / "data.csv");
  }
  return source;
}

std::vector<NamedBytes> encode_euroc_frame(const RgbdCamera& camera, const RgbdFrame& frame,
                                           std::size_t number) {
  std::vector<NamedBytes> files = {
      {folder_of(kCameras, number) + image_name(frame.timestamp), encode_png(frame.image)}};
  if (!frame.depth.empty()) {
    files.push_back({folder_of(kDepths, number) + image_name(depth_timestamp(frame)),
                     encode_png(to_depth_units(frame.depth, camera.depth_units_per_m))});
  }
  return files;
}

std::vector<NamedBytes> encode_euroc_camera(const SequenceSource& source,
                                            const std::vector<double>& depth_stamps,
                                            std::size_t number) {
  const Distortion& lens = source.camera.pinhole.distortion;
  require(lens.model == DistortionModel::kannala_brandt || (lens.k3 == 0 && !lens.is_rational()),
          "EuRoC's sensor.yaml holds k1, k2, p1, p2, expected a lens without k3 to k6, got k3 = ",
          lens.k3);
  const std::string camera = folder_of(kCameras, number);
  std::vector<NamedBytes> files = {{camera + "/data.csv", format_list(source.timestamps)},
                                   {camera + "/sensor.yaml", format_sensor(source, "camera")}};
  if (!depth_stamps.empty()) {
    const std::string depth = folder_of(kDepths, number);
    files.push_back({depth + "/data.csv", format_list(depth_stamps)});
    files.push_back(
        {depth + "/sensor.yaml",
         format_sensor(source, "planar depth, 16 bit, 0 = none") +
             concat("depth_units_per_m: ", format_real(source.camera.depth_units_per_m), "\n")});
  }
  return files;
}

std::vector<NamedBytes> encode_euroc_body(const SequenceSource& source, const SE3& T_body_imu) {
  std::vector<NamedBytes> files;
  if (!source.truth.empty()) {
    files.push_back({std::string(kTruth) + "/data.csv", format_truth(source)});
    files.push_back({std::string(kTruth) + "/sensor.yaml",
                     concat("sensor_type: visual-inertial\ncomment: exact\nworld_up: ",
                            to_string(source.up), "\n", format_matrix({}))});
  }
  if (!source.imu.samples.empty()) {
    files.push_back({std::string(kImu) + "/data.csv", format_imu(source.imu.samples)});
    files.push_back(
        {std::string(kImu) + "/sensor.yaml", format_imu_sensor(source.imu.noise, T_body_imu)});
  }
  return files;
}

std::vector<NamedBytes> encode_euroc_lists(const SequenceSource& source,
                                           const std::vector<double>& depth_stamps) {
  std::vector<NamedBytes> files = encode_euroc_camera(source, depth_stamps);
  for (NamedBytes& file : encode_euroc_body(source)) {
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace vo
