// make_seeds FOLDER: small files of our own writers, as what the fuzzers begin with:
// FOLDER/FUZZER/NAME.
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/bag_file.h"
#include "tests/support/exr_file.h"
#include "tests/support/recordings.h"
#include "tests/support/small_forest.h"
#include "vo/archives/gzip.h"
#include "vo/core/error.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/euroc.h"
#include "vo/dataset/icl_nuim.h"
#include "vo/dataset/sequence.h"
#include "vo/frames/depth_units.h"
#include "vo/image_files/float_image.h"
#include "vo/image_files/flow_file.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/npy.h"
#include "vo/image_files/png.h"
#include "vo/image_files/pnm.h"
#include "vo/image_files/rgbe.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/trajectory_file.h"
#include "vo/recordings/camera_message.h"
#include "vo/structured_forest/structured_forest_file.h"

namespace {

using Seeds = std::vector<vo::NamedBytes>;

constexpr int kWidth = 8;
constexpr int kHeight = 6;

/// An images.txt of COLMAP's.
constexpr const char* kImages = "1 1 0 0 0 0.1 0.2 0.3 1 1.5.png\n2 3 -1\n";

/// Pixels that differ.
cv::Mat pixels(int type, int width = kWidth, int height = kHeight) {
  cv::Mat image(height, width, type);
  for (int v = 0; v < height; ++v) {
    auto* row = image.ptr<std::uint8_t>(v);
    for (std::size_t i = 0; i < static_cast<std::size_t>(width) * image.elemSize(); ++i) {
      row[i] = static_cast<std::uint8_t>(i * 11 + static_cast<std::size_t>(v) * 23);
    }
  }
  return image;
}

/// A PNG whose eXIf chunk states 1.6 GB and ends after its name, for which libpng would ask.
std::string png_with_huge_exif() {
  constexpr std::size_t kAfterHeader = 33;  // the signature and the whole chunk IHDR
  return vo::encode_png(pixels(CV_8UC1)).substr(0, kAfterHeader) + "ddddeXIf";
}

void add_images(Seeds& seeds) {
  seeds.push_back({"png/grey", vo::encode_png(pixels(CV_8UC1))});
  seeds.push_back({"png/huge_exif", png_with_huge_exif()});
  seeds.push_back({"png/colour", vo::encode_png(pixels(CV_8UC3))});
  seeds.push_back({"png/depth", vo::encode_png(pixels(CV_16UC1))});
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC1}) {
    seeds.push_back({"pnm/" + std::to_string(type), vo::encode_pnm(pixels(type))});
  }
  for (const auto& [format, name] : enum_names(vo::FloatFormat{})) {
    const std::string folder(name);
    cv::Mat one(kHeight, kWidth, CV_32FC1, cv::Scalar::all(0.5));
    cv::Mat three(kHeight, kWidth, CV_32FC3, cv::Scalar(1, 2, 3));
    seeds.push_back({folder + "/one", vo::encode_float_image(one, format)});
    seeds.push_back({folder + "/three", vo::encode_float_image(three, format)});
  }
  seeds.push_back(
      {"rgbe/pixels", vo::encode_rgbe(cv::Mat_<cv::Vec3f>(kHeight, kWidth, cv::Vec3f(1, 2, 3)))});
  seeds.push_back({"rgbe/packed", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n"
                                              "\x02\x02\x00\x08\x88\x01\x88\x02\x88\x03\x88\x81",
                                              57)});
  const cv::Mat_<cv::Vec3f> light(kHeight, kWidth, cv::Vec3f(1, 2, 3));
  seeds.push_back({"exr/plain", support::encode_exr(light, Imf::NO_COMPRESSION, Imf::FLOAT)});
  seeds.push_back({"exr/zip", support::encode_exr(light, Imf::ZIP_COMPRESSION, Imf::HALF)});
  seeds.push_back({"exr/piz", support::encode_exr(light, Imf::PIZ_COMPRESSION, Imf::HALF)});
  const cv::Mat_<cv::Vec2f> flow(kHeight, kWidth, cv::Vec2f(1, 2));
  seeds.push_back({"flow/small", vo::encode_flow(flow)});
  for (const auto& [chroma, name] : enum_names(vo::ChromaSampling{})) {
    const auto bytes = vo::encode_jpeg(pixels(CV_8UC3, 16, 12), 50, chroma);
    seeds.push_back({"jpeg/" + std::string(name), {bytes.begin(), bytes.end()}});
  }
}

vo::SequenceSource small_source() {
  vo::SequenceSource source;
  source.camera = {{kWidth, kHeight, 8, 8, 3.5, 2.5}, 1000};
  for (int i = 0; i < 3; ++i) {
    const double timestamp = 0.1 * i;
    source.timestamps.push_back(timestamp);
    source.truth.push_back({timestamp, vo::SE3(Eigen::Quaterniond::Identity(), {timestamp, 0, 1})});
    source.imu.samples.push_back({timestamp, {0.1, 0.2, 0.3}, {0, 9.81, 0}});
    source.imu.states.push_back({timestamp, source.truth.back().T_world_camera, {1, 2, 3}});
  }
  source.imu.noise.rate = 200;
  return source;
}

/// The files one after the other, as `fuzz::InputFolder` takes them apart.
std::string archive_of(const std::vector<vo::NamedBytes>& files) {
  std::string archive;
  for (const vo::NamedBytes& file : files) {
    archive += "=== " + file.name + "\n" + file.bytes + "\n";
  }
  return archive;
}

void add_text(const vo::SequenceSource& source, Seeds& seeds) {
  for (const vo::CameraPreset& preset : vo::camera_presets()) {
    seeds.push_back({"camera/" + preset.name, vo::format_camera(preset.camera)});
  }
  seeds.push_back({"toml/camera", vo::format_camera(source.camera)});
  seeds.push_back({"toml/kinds",
                   "# comment\na = 1\n[b.c]\nd = \"text\\n\"\ne = [[1, 2.5], [3, 4]]\nf = true\n"
                   "g = {h = 'x', i = 1e3}\nj = \"\"\"long\ntext\"\"\"\n"});
  seeds.push_back({"trajectory/poses", vo::format_trajectory(source.truth)});
  seeds.push_back({"trajectory/kitti", vo::format_kitti_poses(source.truth)});
  seeds.push_back({"trajectory/euroc", vo::format_euroc_trajectory(source.truth)});
  seeds.push_back({"trajectory/colmap", kImages});
  seeds.push_back({"timed_trajectory/kitti",
                   archive_of({{"t.txt", vo::format_kitti_poses(source.truth)},
                               {"times.txt", vo::format_kitti_times(source.truth)}})});
  seeds.push_back({"timed_trajectory/colmap",
                   archive_of({{"t.txt", kImages}, {"times.txt", "0.5 rgb/1.5.png\n"}})});
  seeds.push_back({"euroc_trajectory/states", vo::format_states(source.imu.states)});
  seeds.push_back({"imu/readings", vo::format_imu(source.imu.samples)});
  seeds.push_back({"imu/noise", vo::format_imu_noise(source.imu.noise)});
}

void add_forest(Seeds& seeds) {
  const std::string text =
      vo::structured_forest_yaml(support::small_forest(136, 0.125F, {1, 20, 255}));
  seeds.push_back({"forest/yaml", text});
  seeds.push_back({"forest/packed", vo::gzip(text)});
}

void append(std::vector<vo::NamedBytes>& files, const std::vector<vo::NamedBytes>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

/// Sequences of one frame in the layouts that have no lists.
void add_numbered_sequences(const vo::SequenceSource& source, const vo::RgbdFrame& frame,
                            Seeds& seeds) {
  const std::string image = vo::encode_pnm(frame.image);
  const std::string depth = vo::encode_png(vo::to_depth_units(frame.depth, 1000));
  const vo::NamedBytes camera{"camera.toml", vo::format_camera(source.camera)};
  const std::string pose = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  const std::string intrinsics = "8 0 3.5 0\n0 8 2.5 0\n0 0 1 0\n0 0 0 1\n";
  seeds.push_back({"sequence/7-scenes", archive_of({camera,
                                                    {"frame-000000.color.ppm", image},
                                                    {"frame-000000.depth.png", depth},
                                                    {"frame-000000.pose.txt", pose}})});
  seeds.push_back(
      {"sequence/scannet", archive_of({{"color/0.ppm", image},
                                       {"depth/0.png", depth},
                                       {"pose/0.txt", pose},
                                       {"intrinsic/intrinsic_color.txt", intrinsics},
                                       {"intrinsic/intrinsic_depth.txt", intrinsics}})});
  seeds.push_back({"sequence/open3d",
                   archive_of({{"color/000000.ppm", image},
                               {"depth/000000.png", depth},
                               {"trajectory.log", "0 0 1\n" + pose},
                               {"camera_intrinsic.json",
                                "{\"width\": 8, \"height\": 6, \"intrinsic_matrix\": [8, 0, 0, 0, "
                                "8, 0, 3.5, 2.5, 1]}"}})});
  seeds.push_back({"sequence/tartanair",
                   archive_of({camera,
                               {"image_left/000000_left.ppm", image},
                               {"depth_left/000000_left_depth.npy", vo::encode_npy(frame.depth)},
                               {"pose_left.txt", "0 0 0 0 0 0 1\n"}})});
}

void add_sequences(const vo::SequenceSource& source, Seeds& seeds) {
  vo::RgbdFrame frame;
  frame.image = pixels(CV_8UC3);
  frame.depth = vo::DepthImage(kHeight, kWidth, 2.0F);
  const vo::SequenceLayout layout{source.camera};
  auto tum = vo::encode_lists(layout, source.truth);
  append(tum, vo::encode_frame(layout, 0, frame));
  auto euroc = vo::encode_euroc_lists(source, source.timestamps);
  append(euroc, vo::encode_euroc_frame(source.camera, frame));
  auto icl = vo::encode_icl_nuim_lists(source);
  append(icl, vo::encode_icl_nuim_frame(source.camera, 0, frame, {}));
  auto icl_tum = vo::encode_icl_tum_lists(source);
  append(icl_tum, vo::encode_icl_tum_frame(source.camera, 0, frame));
  seeds.push_back({"sequence/tum", archive_of(tum)});
  seeds.push_back({"sequence/euroc", archive_of(euroc)});
  seeds.push_back({"sequence/icl-nuim", archive_of(icl)});
  seeds.push_back({"sequence/icl-tum", archive_of(icl_tum)});
  add_numbered_sequences(source, frame, seeds);
}

/// Recordings of one frame, its camera and its pose, in each layout that is read.
void add_recordings(Seeds& seeds) {
  vo::RosCameraInfo info =
      vo::camera_info_of(vo::PinholeCamera::from_horizontal_fov(kWidth, kHeight, 60));
  info.header = {1, "camera"};
  const std::vector<support::TestMessage> messages = {
      {"/c/camera_info", "sensor_msgs/msg/CameraInfo", 1, vo::encode_cdr(info)},
      support::image_message("/c/image_raw", 1, "rgb8", pixels(CV_8UC3)),
      support::image_message("/d/image_raw", 1, "32FC1", pixels(CV_32FC1)),
      support::pose_message("/pose", support::pose_at_x(1, 1)),
      support::tf_message({support::pose_at_x(1, 1), support::pose_at_x(2, 1)})};
  for (const auto compression :
       {vo::Compression::none, vo::Compression::lz4, vo::Compression::zstd}) {
    const std::string bytes = support::mcap_of(messages, {.compression = compression});
    const std::string name = "recording/" + std::string(vo::to_string(compression));
    seeds.push_back({name, bytes});
    seeds.push_back({name + "_cut", bytes.substr(0, bytes.size() - 8)});
  }
  seeds.push_back(
      {"recording/bag", support::bag_of({support::bag_image("/c/image", 1, "mono8", 1, 9),
                                         support::bag_image("/d/image", 1, "16UC1", 2, 9),
                                         support::bag_pose("/pose", 1, 2)})});
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: make_seeds FOLDER\n", stderr);
    return 1;
  }
  try {
    Seeds seeds;
    const vo::SequenceSource source = small_source();
    add_images(seeds);
    add_text(source, seeds);
    add_forest(seeds);
    add_sequences(source, seeds);
    add_recordings(seeds);
    vo::write_files(arguments[1], seeds, vo::ExistingOutput::replace);
  } catch (const vo::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
