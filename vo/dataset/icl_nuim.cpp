#include "vo/dataset/icl_nuim.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/frame_images.h"
#include "vo/files/folder.h"
#include "vo/files/input.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/png.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/text_files/text_lines.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr double kFramesPerSecond = 30;
constexpr const char* kTrajectory = "trajectory.gt.freiburg";

std::string scene_file(std::size_t index, const char* extension) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "scene_00_%04zu.%s", index, extension);
  return name.data();
}

/// Returns the camera, with y down: the given one, the folder's camera.toml or the preset.
RgbdCamera icl_nuim_camera(const fs::path& folder, const std::optional<RgbdCamera>& given) {
  const fs::path file = folder / "camera.toml";
  const RgbdCamera camera =
      given ? *given : load_camera(fs::exists(file) ? file.string() : "icl-nuim");
  return camera.pinhole.fy < 0 ? mirrored(camera) : camera;
}

/// Returns planar depth over the distance along a pixel's ray; 1 where the lens images nothing.
double share_of_distance(const PinholeCamera& camera, int u, int v) {
  const double share = 1 / camera.unproject({u, v}, 1).norm();
  return std::isnan(share) ? 1 : share;
}

std::string format_distances(const DepthImage& depth, const PinholeCamera& camera) {
  std::string text;
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      std::array<char, 32> number{};
      std::snprintf(number.data(), number.size(), "%.9g ",
                    depth(v, u) / share_of_distance(camera, u, v));
      text += number.data();
    }
  }
  return text + "\n";
}

DepthImage read_distances(const fs::path& path, const PinholeCamera& camera) {
  const std::string text = read_file(path);
  const std::size_t pixels =
      static_cast<std::size_t>(camera.height) * static_cast<std::size_t>(camera.width);
  require(text.size() + 1 >= 2 * pixels, path.string(), ": expected ", pixels, " distances, got ",
          text.size(), " bytes");
  DepthImage depth(camera.height, camera.width);
  const char* at = text.data();
  const char* end = text.data() + text.size();
  const auto skip_blanks = [&] {
    while (at != end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t')) {
      ++at;
    }
  };
  for (int v = 0; v < depth.rows; ++v) {
    for (int u = 0; u < depth.cols; ++u) {
      skip_blanks();
      double distance = 0;
      const auto [next, error] = std::from_chars(at, end, distance);
      require(error == std::errc() && distance >= 0 && distance < kMaxMetres, path.string(),
              ": expected ", depth.total(), " distances, got a value that is none at column ", u,
              ", row ", v);
      depth(v, u) = static_cast<float>(distance * share_of_distance(camera, u, v));
      at = next;
    }
  }
  skip_blanks();
  require(at == end, path.string(), ": expected ", depth.total(), " distances, got more");
  return depth;
}

/// Reads the vector of a line `cam_pos = [x, y, z]';`.
Eigen::Vector3d read_vector(const fs::path& path, const std::string& text, const std::string& key) {
  const std::size_t at = std::min(text.find(key), text.size());
  const std::string line = text.substr(at, text.find('\n', at) - at);
  const std::size_t begin = line.find('[');
  const std::size_t end = line.find(']', begin);
  require(begin != std::string::npos && end != std::string::npos, path.string(), ": expected ", key,
          " = [x, y, z]");
  try {
    const std::vector<double> values = parse_reals(line.substr(begin + 1, end - begin - 1), 3);
    return {values[0], values[1], values[2]};
  } catch (const Error& error) {
    fail(path.string(), ": ", key, ": ", error.what());
  }
}

/// Reads a pose in the data set's frames: z is the viewing direction, x is across it and the up
/// vector.
SE3 read_scene_pose(const fs::path& path) {
  const std::string text = read_file(path);
  const Eigen::Vector3d z = read_vector(path, text, "cam_dir").normalized();
  const Eigen::Vector3d x = read_vector(path, text, "cam_up").cross(z).normalized();
  require(z.allFinite() && x.allFinite() && x.norm() > 0, path.string(),
          ": expected cam_up across cam_dir");
  Eigen::Matrix3d R;
  R << x, z.cross(x), z;
  return checked_pose(path.string(), Eigen::Quaterniond(R), read_vector(path, text, "cam_pos"));
}

std::string format_vector(const char* key, const Eigen::Vector3d& v) {
  std::array<char, 128> line{};
  std::snprintf(line.data(), line.size(), "%-12s = [%.12g, %.12g, %.12g]';\n", key, v.x(), v.y(),
                v.z());
  return line.data();
}

/// Returns a pose as POV-Ray's camera: `right` and `up` are as long as the image is wide and high
/// at the end of `dir`, from which the data set's own programs find the focal lengths. The other
/// values are constant in the data set.
std::string format_scene_pose(const PinholeCamera& camera, const SE3& T_world_camera) {
  const Eigen::Matrix3d R = T_world_camera.rotation_matrix();
  const double width = camera.width / camera.fx;
  const double height = camera.height / std::abs(camera.fy);
  return format_vector("cam_pos", T_world_camera.translation()) +
         format_vector("cam_dir", R.col(2)) + format_vector("cam_up", height * R.col(1)) +
         format_vector("cam_lookat", Eigen::Vector3d::UnitZ()) +
         format_vector("cam_sky", Eigen::Vector3d::UnitY()) +
         format_vector("cam_right", width * R.col(0)) +
         format_vector("cam_fpoint", 10 * Eigen::Vector3d::UnitZ()) + "cam_angle    = 90;\n";
}

fs::path find_trajectory(const fs::path& folder) {
  for (const FolderEntry& entry : entries_of(folder)) {
    if (entry.name.ends_with(".gt.freiburg")) {
      return folder / entry.name;
    }
  }
  return {};
}

double time_of(double frame) {
  return frame / kFramesPerSecond;
}

}  // namespace

SE3 mirrored(const SE3& T_world_camera) {
  const Eigen::DiagonalMatrix<double, 3> world(1, 1, -1);
  const Eigen::DiagonalMatrix<double, 3> camera(1, -1, 1);
  const Eigen::Matrix3d R = world * T_world_camera.rotation_matrix() * camera;
  return {Eigen::Quaterniond(R), world * T_world_camera.translation()};
}

RgbdCamera mirrored(const RgbdCamera& camera) {
  RgbdCamera result = camera;
  result.pinhole.fy = -camera.pinhole.fy;
  result.pinhole.distortion.p1 = -camera.pinhole.distortion.p1;
  return result;
}

SequenceSource open_icl_nuim(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  SequenceSource source;
  source.camera = icl_nuim_camera(folder, camera);
  source.up = WorldUp::y;
  source.has_float_depth = true;
  for (std::size_t i = 0; fs::exists(folder / scene_file(i, "png")); ++i) {
    source.timestamps.push_back(time_of(static_cast<double>(i)));
    const fs::path pose = folder / scene_file(i, "txt");
    source.truth.push_back({source.timestamps.back(), mirrored(read_scene_pose(pose))});
  }
  require(!source.timestamps.empty(), folder.string(), ": expected scene_00_0000.png");
  source.read = [folder, camera = source.camera](std::size_t index) {
    const fs::path image = folder / scene_file(index, "png");
    RgbdFrame frame{
        time_of(static_cast<double>(index)), read_frame_image(image, camera.pinhole), {}};
    frame.depth = read_distances(folder / scene_file(index, "depth"), camera.pinhole);
    return frame;
  };
  return source;
}

SequenceSource open_icl_tum(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  SequenceSource source;
  source.camera = icl_nuim_camera(folder, camera);
  source.up = WorldUp::y;
  std::vector<std::pair<fs::path, fs::path>> files;  // image, depth
  TextFile(folder / "associations.txt").for_each_line([&](const TextLine& line) {
    require(line.fields.size() == 4, line.place(),
            ": expected `number depth/number.png number rgb/number.png`, got ", line.fields.size(),
            " values");
    const double timestamp = time_of(parse_timestamp(line, 0));
    require(source.timestamps.empty() || timestamp > source.timestamps.back(), line.place(),
            ": expected a frame after the one before it, got ", line.fields[0]);
    source.timestamps.push_back(timestamp);
    files.emplace_back(path_in(folder, std::string(line.fields[3]), line.place()),
                       path_in(folder, std::string(line.fields[1]), line.place()));
  });
  require(!files.empty(), (folder / "associations.txt").string(), ": lists no frames");
  source.read = [files, camera = source.camera, timestamps = source.timestamps](std::size_t index) {
    const auto& [image, depth] = files.at(index);
    return RgbdFrame{timestamps[index], read_frame_image(image, camera.pinhole),
                     read_depth_png(depth, camera)};
  };
  if (const fs::path trajectory = find_trajectory(folder); !trajectory.empty()) {
    for (const auto& [number, T_world_camera] :
         read_truth(trajectory, TrajectoryFormat::tum, source.notes)) {
      source.truth.push_back({time_of(number), mirrored(T_world_camera)});
    }
  }
  return source;
}

std::vector<NamedBytes> encode_icl_nuim_frame(const RgbdCamera& camera, std::size_t index,
                                              const RgbdFrame& frame, const SE3& T_world_camera) {
  require(!frame.depth.empty(), "ICL-NUIM: expected frames with depth");
  return {{scene_file(index, "png"), encode_png(frame.image)},
          {scene_file(index, "depth"), format_distances(frame.depth, camera.pinhole)},
          {scene_file(index, "txt"), format_scene_pose(camera.pinhole, mirrored(T_world_camera))}};
}

std::vector<NamedBytes> encode_icl_tum_frame(const RgbdCamera& camera, std::size_t index,
                                             const RgbdFrame& frame) {
  require(!frame.depth.empty(), "ICL-NUIM: expected frames with depth");
  const std::string name = std::to_string(index) + ".png";
  return {{"rgb/" + name, encode_png(frame.image)},
          {"depth/" + name, encode_png(to_depth_units(frame.depth, camera.depth_units_per_m))}};
}

std::vector<NamedBytes> encode_icl_nuim_lists(const SequenceSource& source) {
  return {{"camera.toml", format_camera(mirrored(source.camera))}};
}

std::vector<NamedBytes> encode_icl_tum_lists(const SequenceSource& source) {
  std::string associations;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    associations += concat(i, " depth/", i, ".png ", i, " rgb/", i, ".png\n");
  }
  std::vector<NamedBytes> files = {{"associations.txt", associations},
                                   {"camera.toml", format_camera(mirrored(source.camera))}};
  Trajectory numbered;
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    if (const auto T_world_camera = pose_at(source.truth, source.timestamps[i])) {
      numbered.push_back({static_cast<double>(i), mirrored(*T_world_camera)});
    }
  }
  if (!numbered.empty()) {
    files.push_back({kTrajectory, format_trajectory(numbered)});
  }
  return files;
}

}  // namespace vo
