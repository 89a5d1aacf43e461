#include "vo/dataset/sequence_source.h"

#include <memory>

#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/euroc.h"
#include "vo/dataset/icl_nuim.h"
#include "vo/dataset/open3d.h"
#include "vo/dataset/scannet.h"
#include "vo/dataset/sequence.h"
#include "vo/dataset/seven_scenes.h"
#include "vo/dataset/tartanair.h"
#include "vo/motion_files/imu_file.h"
#include "vo/text_files/toml_file.h"
#include "vo/videos/video_container.h"
#include "vo/videos/video_sequence.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

struct WorldFile {
  WorldUp up = WorldUp::unknown;
};

template <typename Visitor>
void visit_fields(Visitor& visit, WorldFile& world) {
  visit("up", world.up, "axis of the world that points up");
}

/// Returns the axis that world.toml names; rendered sequences have the scene's world, glTF's.
WorldUp up_of_tum(const fs::path& folder) {
  WorldFile world;
  if (fs::exists(folder / kWorldFile)) {
    std::vector<Field> fields = fields_of(world);
    assign_fields(read_toml(folder / kWorldFile), fields);
  } else if (fs::exists(folder / "sequence.toml")) {
    world.up = WorldUp::y;
  }
  return world.up;
}

/// Throws Error for a folder that holds the sequences of several cameras, whatever those are
/// called.
void require_one_camera(const fs::path& folder) {
  require(!fs::exists(folder / "rig.toml"), folder.string(),
          ": is a rig, expected the folder of one of its cameras, which its rig.toml names");
}

SequenceContent content_of_tum(const fs::path& folder) {
  if (fs::exists(folder / "depth_float.txt")) {
    return SequenceContent::colour_and_float_depth;
  }
  return fs::exists(folder / "depth.txt") ? SequenceContent::colour_and_depth
                                          : SequenceContent::colour;
}

SequenceSource open_tum(const fs::path& folder, const std::optional<RgbdCamera>& camera) {
  constexpr double kMaxTimeDifference = 0.02;  // s
  SequenceSource source;
  source.has_float_depth = fs::exists(folder / "depth_float.txt");
  const auto reader = std::make_shared<const SequenceReader>(folder, camera, kMaxTimeDifference,
                                                             content_of_tum(folder));
  source.up = up_of_tum(folder);
  source.camera = reader->camera();
  source.timestamps = reader->timestamps();
  source.read = [reader](std::size_t index) { return reader->read(index); };
  source.truth = reader->ground_truth();
  source.notes = reader->notes();
  if (fs::exists(folder / "imu.csv")) {
    source.imu.samples = read_imu(folder / "imu.csv");
  }
  if (fs::exists(folder / "imu.toml")) {
    source.imu.noise = read_imu_noise(folder / "imu.toml");
  }
  if (fs::exists(folder / "truth/imu_states.csv")) {
    source.imu.states = read_states(folder / "truth/imu_states.csv");
  }
  return source;
}

SequenceFormat format_of_recording(const fs::path& file) {
  return recording_format(file) == RecordingFormat::bag ? SequenceFormat::bag
                                                        : SequenceFormat::mcap;
}

std::optional<SequenceFormat> format_of_file(const fs::path& file) {
  if (recording_format(file)) {
    return format_of_recording(file);
  }
  return video_container(file) ? std::optional(SequenceFormat::video) : std::nullopt;
}

SequenceSource open_recording_of(const fs::path& path, SequenceFormat format,
                                 const std::optional<RgbdCamera>& camera,
                                 const RecordingRequest& request) {
  const fs::path file = recording_at(path);
  require(!file.empty() && format_of_recording(file) == format, path.string(), ": is no ",
          to_string(format), " recording");
  return open_recording(file, camera, request);
}

}  // namespace

std::optional<SequenceFormat> known_format(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    return format_of_file(folder);
  }
  require_one_camera(folder);
  if (fs::exists(folder / "mav0/cam0/data.csv")) {
    return SequenceFormat::euroc;
  }
  if (fs::exists(folder / "scene_00_0000.png")) {
    return SequenceFormat::icl_nuim;
  }
  if (fs::exists(folder / "rgb.txt") || fs::exists(folder / "sequence.toml")) {
    return SequenceFormat::tum;
  }
  if (fs::exists(folder / "associations.txt")) {
    return SequenceFormat::icl_tum;
  }
  if (fs::is_directory(folder / "intrinsic") && fs::is_directory(folder / "color")) {
    return SequenceFormat::scannet;
  }
  if (fs::is_directory(folder / "image_left")) {
    return SequenceFormat::tartanair;
  }
  if (!open3d_images(folder).empty()) {
    return SequenceFormat::open3d;
  }
  if (holds_seven_scenes(folder)) {
    return SequenceFormat::seven_scenes;
  }
  if (fs::is_directory(folder) && !recording_at(folder).empty()) {
    return format_of_recording(recording_at(folder));
  }
  return std::nullopt;
}

SequenceFormat detect_format(const fs::path& path) {
  require(fs::exists(path), path.string(), ": there is no such folder, expected a sequence");
  const std::optional<SequenceFormat> format = known_format(path);
  require(format.has_value() || fs::is_directory(path), path.string(), kNoSequenceFile);
  require(
      format.has_value(), path.string(),
      ": holds no sequence that is known, expected rgb.txt (TUM), mav0/cam0/data.csv (EuRoC), "
      "scene_00_0000.png (ICL-NUIM), associations.txt (ICL-NUIM, TUM compatible), "
      "frame-000000.color.png (7-Scenes), intrinsic and color (ScanNet), image_left (TartanAir), "
      "color, rgb or image beside depth (Open3D, Redwood) or one .mcap (ROS 2)");
  return *format;
}

SequenceSource open_sequence(const fs::path& folder, SequenceFormat format,
                             const std::optional<RgbdCamera>& camera,
                             const RecordingRequest& request) {
  const bool is_recorded = format == SequenceFormat::mcap || format == SequenceFormat::bag;
  require(is_recorded || request.topics.are_free(), folder.string(),
          ": is no recording, of which topics are chosen");
  switch (format) {
    case SequenceFormat::tum:
      return open_tum(folder, camera);
    case SequenceFormat::euroc:
      return open_euroc(folder, camera);
    case SequenceFormat::icl_nuim:
      return open_icl_nuim(folder, camera);
    case SequenceFormat::icl_tum:
      return open_icl_tum(folder, camera);
    case SequenceFormat::seven_scenes:
      return open_seven_scenes(folder, camera);
    case SequenceFormat::scannet:
      return open_scannet(folder, camera);
    case SequenceFormat::open3d:
      return open_open3d(folder, camera);
    case SequenceFormat::tartanair:
      return open_tartanair(folder, camera);
    case SequenceFormat::mcap:
    case SequenceFormat::bag:
      return open_recording_of(folder, format, camera, request);
    case SequenceFormat::video:
      return open_video(folder, camera);
  }
  return {};
}

}  // namespace vo
