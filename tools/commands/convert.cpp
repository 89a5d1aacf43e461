#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/cli/options.h"
#include "tools/cli/progress_bar.h"
#include "tools/cli/scene_arguments.h"
#include "tools/cli/standard_streams.h"
#include "tools/cli/topic_arguments.h"
#include "tools/cli/trajectory_arguments.h"
#include "tools/commands/commands.h"
#include "tools/commands/track_arguments.h"
#include "tools/json/document.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/exports/convert_sequence.h"
#include "vo/files/output.h"
#include "vo/geometry/associate.h"
#include "vo/motion_files/recorded_trajectory.h"
#include "vo/motion_files/timestamp.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/videos/video_container.h"

namespace tools {
namespace {

constexpr const char* kConvertHelp =
    "Writes a sequence, IN a folder, recording or video, in another format, its poses, camera and "
    "IMU "
    "included, or a\n"
    "trajectory, IN a file. Sequences:\n"
    "  tum       rgb/, depth/ (16 bit), rgb.txt, depth.txt, groundtruth.txt, camera.toml,\n"
    "            imu.csv, imu.toml\n"
    "  euroc     mav0/cam0, imu0, state_groundtruth_estimate0 (ns, quaternion w first; at the\n"
    "            IMU's stamps if there is one, not the frames'), and mav0/depth0 (16 bit, "
    "planar),\n"
    "            which is ours\n"
    "  icl-nuim  scene_00_NNNN.png, .depth (text, m along the ray), .txt (POV-Ray's camera)\n"
    "  icl-tum   the \"TUM compatible\" form: rgb/N.png, depth/N.png, associations.txt,\n"
    "            *.gt.freiburg\n"
    "  mcap      one file for Foxglove, Rerun and ROS 2: images, depth, CameraInfo, poses as\n"
    "            PoseStamped and /tf\n"
    "  video     the images at their mean rate: OUT.avi keeps every pixel (FFV1), OUT.mp4 is "
    "small\n"
    "            (MPEG-4)\n"
    "Both forms of ICL-NUIM have a camera with y up (fy < 0) in a left-handed world and no stamps\n"
    "(30 Hz): converting turns them round. Depth beyond 16 bit becomes 0 and is counted. What a\n"
    "format cannot hold is named; where it has no lens distortion, images are undistorted. "
    "7-Scenes,\n"
    "ScanNet, Open3D's and Redwood's folders and ROS 1 bags are read, too, and not written. For\n"
    "other programs:\n"
    "  tartanair        image_left/, depth_left/ (.npy, m), pose_left.txt, and our camera.toml\n"
    "  kitti            its odometry: sequences/00/image_2/ (grey: image_0/), times.txt, "
    "calib.txt,\n"
    "                   and poses/00.txt in the first camera; no depth\n"
    "  colmap           images/, sparse/0/cameras.txt, images.txt, points3D.txt (from depth)\n"
    "  transforms-json  Nerfstudio's transforms.json, images/, depths/ (16 bit, mm)\n"
    "  mcap             a file of ROS 2: Image, CameraInfo, PoseStamped, tf (--points: "
    "PointCloud2)\n"
    "Poses are turned into a world with z up for euroc and transforms-json (--world), if it is "
    "known\n"
    "which axis points up: y in a rendered sequence, what world.toml says, what a format has.\n"
    "Trajectories, of any format that is read:\n"
    "  tum       timestamp tx ty tz qx qy qz qw, s\n"
    "  euroc     timestamp,px,py,pz,qw,qx,qy,qz, ns, as its ground truth without velocity and "
    "biases\n"
    "  kitti     the upper three rows of each pose's matrix, and the stamps in a file beside it:\n"
    "            poses_times.txt for poses.txt";

constexpr const char* kConvertExamples =
    "Examples:\n"
    "  edvo convert sequence sequence_euroc --format euroc\n"
    "  edvo convert sequence sequence.mcap --format mcap\n"
    "  edvo convert sequence nerf --format transforms-json\n"
    "  edvo convert sequence sequence.avi --format video\n"
    "  edvo convert fr1_xyz model --format colmap --camera tum-fr1\n"
    "  edvo convert living_room_traj0 sequence --format tum\n"
    "  edvo convert estimate.txt poses.txt --format kitti\n"
    "  edvo convert poses/00.txt groundtruth.txt --format tum --times sequences/00/times.txt";

struct ConvertArguments {
  CommonOptions common;
  std::string in;
  std::string out;
  std::string format;
  std::string from;
  std::string camera;
  std::string times;
  vo::SequenceTopics topics;
  std::string compression = "zstd";
  bool points = false;
  std::string world;
};

/// The worlds that are chosen by name.
enum class World { y_up, z_up };

constexpr auto enum_names(World) {
  return std::array{std::pair{World::y_up, "y-up"}, std::pair{World::z_up, "z-up"}};
}

vo::ConvertJob chosen_job(const ConvertArguments& arguments) {
  vo::ConvertJob job{.in = arguments.in, .out = arguments.out};
  check_usage([&] {
    job.to = vo::parse_enum<vo::WrittenSequence>(arguments.format);
    if (!arguments.world.empty()) {
      job.up =
          vo::parse_enum<World>(arguments.world) == World::y_up ? vo::WorldUp::y : vo::WorldUp::z;
    }
    if (!arguments.from.empty()) {
      job.from = vo::parse_enum<vo::SequenceFormat>(arguments.from);
    }
  });
  job.camera = given_camera(arguments.camera);
  job.recorded.topics = arguments.topics;
  job.mcap.compression = vo::parse_enum<vo::Compression>(arguments.compression);
  job.mcap_clouds = arguments.points ? vo::PointClouds::written : vo::PointClouds::none;
  return job;
}

void print(const ConvertArguments& arguments, const vo::ConvertOutcome& outcome,
           const Colours& colours) {
  if (arguments.common.json) {
    const nlohmann::ordered_json result = {{"out", arguments.out},
                                           {"from", vo::to_string(outcome.from)},
                                           {"format", arguments.format},
                                           {"frames", outcome.frames},
                                           {"poses", outcome.poses},
                                           {"imu_samples", outcome.imu_samples},
                                           {"depth_beyond_16_bit", outcome.depth_beyond_16_bit},
                                           {"world_up", vo::to_string(outcome.up)},
                                           {"dropped", outcome.dropped},
                                           {"notes", outcome.notes}};
    std::cout << json_text(json_document({"convert"}, result));
    return;
  }
  std::cout << arguments.out << ": " << outcome.frames << " frames, " << outcome.poses << " poses, "
            << outcome.imu_samples << " IMU samples\n";
  if (outcome.depth_beyond_16_bit > 0) {
    std::cout << outcome.depth_beyond_16_bit << " depth pixels beyond 16 bit became 0\n";
  }
  for (const std::string& dropped : outcome.dropped) {
    std::cout << colours.paint(Tone::caution, "dropped") << "  " << dropped << "\n";
  }
  std::cout << note_lines(outcome.notes, colours);
}

/// The formats in which a trajectory is written.
enum class WrittenTrajectory { tum, euroc, kitti };

constexpr auto enum_names(WrittenTrajectory) {
  return std::array{std::pair{WrittenTrajectory::tum, "tum"},
                    std::pair{WrittenTrajectory::euroc, "euroc"},
                    std::pair{WrittenTrajectory::kitti, "kitti"}};
}

WrittenTrajectory chosen_trajectory_format(const ConvertArguments& arguments) {
  try {
    return vo::parse_enum<WrittenTrajectory>(arguments.format);
  } catch (const vo::Error& error) {
    vo::fail_as(vo::ErrorKind::usage, "--format: ", error.what(), " for ", arguments.in,
                ", a trajectory");
  }
}

/// Returns the files that a trajectory becomes, the trajectory first.
std::vector<vo::NamedBytes> encode_trajectory(const std::filesystem::path& out,
                                              WrittenTrajectory format,
                                              const vo::Trajectory& trajectory) {
  switch (format) {
    case WrittenTrajectory::tum:
      return {{out, vo::format_trajectory(trajectory)}};
    case WrittenTrajectory::euroc:
      return {{out, vo::format_euroc_trajectory(trajectory)}};
    case WrittenTrajectory::kitti:
      return {{out, vo::format_kitti_poses(trajectory)},
              {beside(out, "_times.txt"), vo::format_kitti_times(trajectory)}};
  }
  return {};
}

void print(const ConvertArguments& arguments, const vo::TrajectoryFile& file,
           const Colours& colours) {
  if (arguments.common.json) {
    const nlohmann::ordered_json result = {{"out", arguments.out},
                                           {"from", vo::to_string(file.format)},
                                           {"format", arguments.format},
                                           {"poses", file.trajectory.size()},
                                           {"notes", file.notes}};
    std::cout << json_text(json_document({"convert_trajectory"}, result));
    return;
  }
  std::cout << arguments.out << ": " << file.trajectory.size() << " poses\n";
  std::cout << note_lines(file.notes, colours);
}

void convert_trajectory(const ConvertArguments& arguments, const Session& session) {
  const WrittenTrajectory format = chosen_trajectory_format(arguments);
  vo::require_writable(arguments.out);
  const vo::TrajectoryFile file = vo::read_trajectory_file(
      arguments.in, chosen_reading({.format = arguments.from, .times = arguments.times}));
  require_times_used(arguments.times, {file.format});
  if (format == WrittenTrajectory::euroc) {
    vo::require_nanoseconds_apart(vo::timestamps_of(file.trajectory), arguments.in);
  }
  const std::vector<vo::NamedBytes> files =
      encode_trajectory(arguments.out, format, file.trajectory);
  const vo::OutputPolicy policy = arguments.common.output_policy();
  for (const auto& [name, bytes] : files) {
    vo::require_no_conflict(name, bytes, policy.existing);
  }
  for (const auto& [name, bytes] : files) {
    vo::write_file(name, bytes, policy);
  }
  print(arguments, file, session.out);
}

void convert_sequence(const ConvertArguments& arguments, const Session& session) {
  const vo::ConvertJob job = chosen_job(arguments);
  ProgressBar bar("converting", arguments.common.verbosity());
  bar.announce("reading " + arguments.in);
  const vo::ConvertOutcome outcome =
      vo::convert_sequence(job, arguments.common.output_policy(), bar.callback());
  bar.erase();
  print(arguments, outcome, session.out);
}

/// Throws where an option is given that what is converted has no use for.
void refuse_ignored(const CLI::App& command, const ConvertArguments& arguments,
                    bool is_trajectory) {
  const auto refuse = [&](const std::vector<const char*>& options, const std::string& expected) {
    for (const char* option : options) {
      if (command.count(option) > 0) {
        vo::fail_as(vo::ErrorKind::usage, option, ": expected ", expected);
      }
    }
  };
  if (is_trajectory) {
    refuse({"--world", "--camera", "--points", "--compression", "--rgb-topic", "--depth-topic",
            "--camera-topic", "--truth-topic"},
           "a sequence, got a trajectory, " + arguments.in);
  } else {
    refuse({"--times"}, "a trajectory, got a sequence, " + arguments.in);
  }
  if (arguments.format != vo::to_string(vo::WrittenSequence::mcap)) {
    refuse({"--points", "--compression"}, "--format mcap, got " + arguments.format);
  }
}

/// Returns whether IN is a trajectory: a file that is no video, but of recordings those of which a
/// topic is named, or which have no images.
bool is_trajectory(const ConvertArguments& arguments) {
  const vo::RecordingName name = vo::recording_name(arguments.in);
  vo::require(std::filesystem::exists(name.file), arguments.in,
              ": there is no such folder or file, expected a sequence or a trajectory");
  if (!std::filesystem::is_regular_file(name.file) || !vo::recording_format(name.file)) {
    return std::filesystem::is_regular_file(name.file) && !vo::video_container(name.file);
  }
  return !name.topic.empty() || !vo::records_images(name.file);
}

}  // namespace

void add_convert_command(CLI::App& program, Session& session) {
  CLI::App& command = *program.add_subcommand("convert", kConvertHelp);
  const auto arguments = std::make_shared<ConvertArguments>();
  command.footer(kConvertExamples);
  command.add_option("IN", arguments->in, "folder of a sequence, recording, video or trajectory")
      ->required();
  command.add_option("OUT", arguments->out, "folder or file to make")->required();
  command
      .add_option(
          "--format", arguments->format,
          "tum | euroc | icl-nuim | icl-tum | tartanair | kitti | colmap | transforms-json | "
          "mcap | video, of a trajectory tum | euroc | kitti")
      ->required();
  command.add_option("--from", arguments->from, "the format of IN, where it is not found out");
  command.add_option("--camera", arguments->camera, "preset or FILE.toml, instead of IN's own");
  command.add_option("--times", arguments->times,
                     "list of the stamps of a trajectory without (KITTI, COLMAP)");
  add_topic_options(command, arguments->topics);
  command
      .add_option("--compression", arguments->compression,
                  "of an MCAP file, none | lz4 | zstd [zstd]")
      ->check(CLI::IsMember({"none", "lz4", "zstd"}));
  command.add_flag("--points", arguments->points,
                   "the points of each depth image in an MCAP file, too");
  command.add_option("--world", arguments->world,
                     "y-up | z-up: the axis of the world that is written (tum, euroc, colmap, "
                     "transforms-json) [euroc and transforms-json: z-up, others: as it is]");
  add_common_options(command, arguments->common);
  take_streams(
      command,
      {.inputs = {"--times"}, .configurations = {"--camera"}, .read = {"IN"}, .written = {"OUT"}});
  command.callback([arguments, &command, &session] {
    const bool has_poses_alone = is_trajectory(*arguments);
    refuse_ignored(command, *arguments, has_poses_alone);
    if (has_poses_alone) {
      convert_trajectory(*arguments, session);
    } else {
      convert_sequence(*arguments, session);
    }
  });
}

}  // namespace tools
