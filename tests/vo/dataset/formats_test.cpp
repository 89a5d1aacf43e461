#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/temp_folder.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/euroc.h"
#include "vo/dataset/icl_nuim.h"
#include "vo/dataset/sequence.h"
#include "vo/files/input.h"
#include "vo/frames/depth_units.h"
#include "vo/geometry/associate.h"
#include "vo/motion_files/imu_file.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::HasSubstr;

constexpr std::size_t kFrames = 3;

/// Three frames of 6x4 px with a lens, poses and an IMU.
vo::SequenceSource example() {
  vo::SequenceSource source;
  source.camera = {{6, 4, 5, 5.5, 2.4, 1.6, {0.1, -0.02, 0.003, 0.004, 0}}, 1000};
  source.truth = support::example_trajectory(kFrames, 30);
  for (const vo::StampedPose& pose : source.truth) {
    source.timestamps.push_back(pose.timestamp);
  }
  source.read = [timestamps = source.timestamps](std::size_t index) {
    vo::RgbdFrame frame{timestamps[index], cv::Mat(4, 6, CV_8UC3), vo::DepthImage(4, 6)};
    for (int i = 0; i < 24; ++i) {
      const auto value = static_cast<uchar>(10 * i + static_cast<int>(index));
      frame.image.at<cv::Vec3b>(i / 6, i % 6) = {value, static_cast<uchar>(255 - value), 7};
      frame.depth(i / 6, i % 6) = i == 5 ? 0 : 0.5F + 0.25F * static_cast<float>(i);
    }
    return frame;
  };
  return source;
}

void expect_same(const vo::SequenceSource& copy, const vo::SequenceSource& source,
                 double depth_error) {
  ASSERT_EQ(copy.timestamps.size(), source.timestamps.size());
  ASSERT_EQ(copy.truth.size(), source.truth.size());
  for (std::size_t i = 0; i < kFrames; ++i) {
    EXPECT_NEAR(copy.timestamps[i], source.timestamps[i], 1e-6);
    EXPECT_LT(
        (copy.truth[i].T_world_camera.inverse() * source.truth[i].T_world_camera).log().norm(),
        1e-8);
    EXPECT_EQ(cv::norm(copy.read(i).image, source.read(i).image, cv::NORM_INF), 0);
    EXPECT_LE(cv::norm(copy.read(i).depth, source.read(i).depth, cv::NORM_INF), depth_error);
  }
  const vo::PinholeCamera& a = copy.camera.pinhole;
  const vo::PinholeCamera& b = source.camera.pinhole;
  const Eigen::Vector3d point(0.3, -0.2, 1);
  EXPECT_LT((a.project(point) - b.project(point)).norm(), 1e-12);
}

TEST(Euroc, ReadsBackWithDepthPosesAndImu) {
  vo::SequenceSource source = example();
  source.imu.samples = {{0, {1, 2, 3}, {4, 5, 6}}, {0.005, {1, 2, 3}, {4, 5, 7}}};
  source.imu.noise = {200, 1.7e-4, 1.9e-5, 2e-3, 3e-3};
  for (const vo::StampedPose& pose : source.truth) {
    source.imu.states.push_back({pose.timestamp, pose.T_world_camera, {1, 2, 3}});
  }
  const TempFolder folder;
  for (std::size_t i = 0; i < kFrames; ++i) {
    vo::write_files(folder.path(), vo::encode_euroc_frame(source.camera, source.read(i)));
  }
  vo::write_files(folder.path(), vo::encode_euroc_lists(source, source.timestamps));
  EXPECT_EQ(vo::detect_format(folder.path()), vo::SequenceFormat::euroc);
  const auto copy = vo::open_sequence(folder.path(), vo::SequenceFormat::euroc);
  expect_same(copy, source, 0.5 / 1000 + 1e-6);
  EXPECT_EQ(copy.imu.samples.size(), 2U);
  EXPECT_EQ(copy.imu.states.size(), 3U);
  EXPECT_NEAR(copy.imu.samples[1].specific_force.z(), 7, 1e-12);
  EXPECT_EQ(copy.imu.noise.rate, 200);
  EXPECT_EQ(copy.imu.noise.gyro_noise, 1.7e-4);
  EXPECT_EQ(copy.imu.noise.gyro_bias_walk, 1.9e-5);
  EXPECT_EQ(copy.imu.noise.accel_noise, 2e-3);
  EXPECT_EQ(copy.imu.noise.accel_bias_walk, 3e-3);
}

TEST(Euroc, StampsOfOurTimeReadBackToTheBit) {
  vo::SequenceSource source = example();
  for (std::size_t i = 0; i < kFrames; ++i) {
    source.timestamps[i] += 1305031102.175304;
    source.truth[i].timestamp = source.timestamps[i];
  }
  const TempFolder folder;
  vo::write_files(folder.path(), vo::encode_euroc_lists(source, source.timestamps));
  const auto copy = vo::open_sequence(folder.path(), vo::SequenceFormat::euroc);
  EXPECT_EQ(copy.timestamps, source.timestamps);
  EXPECT_EQ(vo::timestamps_of(copy.truth), source.timestamps);
}

TEST(Euroc, HoldsAFisheyeAsEquidistant) {
  vo::SequenceSource source = example();
  source.camera.pinhole.distortion = {.k1 = -0.01,
                                      .k2 = 0.02,
                                      .k3 = -0.003,
                                      .k4 = 0.004,
                                      .model = vo::DistortionModel::kannala_brandt};
  const TempFolder folder;
  vo::write_files(folder.path(), vo::encode_euroc_frame(source.camera, source.read(0)));
  vo::write_files(folder.path(), vo::encode_euroc_lists(source, source.timestamps));
  EXPECT_THAT(vo::read_file(folder.path() / "mav0/cam0/sensor.yaml"),
              HasSubstr("distortion_model: equidistant\n"
                        "distortion_coefficients: [-0.01, 0.02, -0.003, 0.004]"));
  const auto copy = vo::open_sequence(folder.path(), vo::SequenceFormat::euroc);
  EXPECT_EQ(vo::format_camera(copy.camera), vo::format_camera(source.camera));
}

TEST(Euroc, KalibrsNameOfTheLensIsKnown) {
  const vo::SequenceSource source = example();
  const TempFolder folder;
  vo::write_files(folder.path(), vo::encode_euroc_lists(source, source.timestamps));
  std::string sensor = vo::read_file(folder.path() / "mav0/cam0/sensor.yaml");
  const std::string name = "radial-tangential";
  sensor.replace(sensor.find(name), name.size(), "radtan");
  folder.write("mav0/cam0/sensor.yaml", sensor);
  const auto copy = vo::open_sequence(folder.path(), vo::SequenceFormat::euroc);
  EXPECT_EQ(copy.camera.pinhole.distortion.k1, 0.1);
  EXPECT_EQ(copy.camera.pinhole.distortion.p2, 0.004);
}

TEST(Euroc, PosesAreTheBodysAndTheCameraHasItsPlaceOnIt) {
  vo::SequenceSource source = example();
  source.T_body_camera = support::example_pose(3);
  const TempFolder folder;
  for (std::size_t i = 0; i < kFrames; ++i) {
    vo::write_files(folder.path(), vo::encode_euroc_frame(source.camera, source.read(i)));
  }
  vo::write_files(folder.path(), vo::encode_euroc_lists(source, source.timestamps));
  const auto copy = vo::open_sequence(folder.path(), vo::SequenceFormat::euroc);
  EXPECT_LT((copy.T_body_camera.inverse() * source.T_body_camera).log().norm(), 1e-9);
  expect_same(copy, source, 0.5 / 1000 + 1e-6);
}

TEST(Euroc, ErrorsNameTheFileAndWhatIsMissing) {
  const TempFolder folder;
  folder.write("mav0/cam0/data.csv", "#timestamp [ns],filename\n12,12.png\n11,11.png\n");
  const std::string sensor =
      "T_BS:\n  cols: 4\n  rows: 4\n  data: [1, 0, 0, 0,\n   0, 1, 0, 0,\n   0, 0, 1, 0,\n"
      "   0, 0, 0, 1]\nresolution: [752, 480]\nintrinsics: [458.6, 457.3, 367.2, 248.4]\n"
      "distortion_model: radial-tangential\n";
  const auto open = [&] { vo::open_sequence(folder.path(), vo::SequenceFormat::euroc); };
  folder.write("mav0/cam0/sensor.yaml", sensor);
  EXPECT_THAT(error_text(open), HasSubstr("sensor.yaml: distortion_coefficients: "));
  folder.write("mav0/cam0/sensor.yaml", sensor + "distortion_coefficients: [-0.28, 0.07, 0, 0]\n");
  EXPECT_THAT(error_text(open), HasSubstr("data.csv:3: expected a stamp after"));
  vo::SequenceSource source = example();
  source.camera.pinhole.distortion.k3 = 1;
  EXPECT_THAT(error_text([&] { vo::encode_euroc_lists(source, source.timestamps); }),
              HasSubstr("expected a lens without k3 to k6"));
}

TEST(Euroc, DepthHasAsManyImagesAsTheCamera) {
  const TempFolder folder;
  vo::write_files(folder.path(), vo::encode_euroc_lists(example(), {0.0}));
  EXPECT_THAT(
      error_text([&] { vo::open_sequence(folder.path(), vo::SequenceFormat::euroc); }),
      HasSubstr("depth0/data.csv: lists 1 depth images, expected as many as the 3 images of cam0"));
}

TEST(Euroc, SizesAndUnitsThatNoImageHasAreErrors) {
  const TempFolder folder;
  vo::write_files(folder.path(), vo::encode_euroc_lists(example(), example().timestamps));
  const auto error_with = [&](const std::string& file, const std::string& from,
                              const std::string& to) {
    std::string text = vo::read_file(folder.path() / file);
    const std::string before = text;
    text.replace(text.find(from), text.find('\n', text.find(from)) - text.find(from), to);
    folder.write(file, text);
    const std::string error =
        error_text([&] { vo::open_sequence(folder.path(), vo::SequenceFormat::euroc); });
    folder.write(file, before);
    return error;
  };
  for (const char* size : {"[1e300, 4]", "[-1, 4]", "[6.5, 4]", "[6, 16385]"}) {
    EXPECT_THAT(
        error_with("mav0/cam0/sensor.yaml", "resolution:", "resolution: " + std::string(size)),
        HasSubstr("sensor.yaml: resolution: expected whole numbers from 1 to 16384"));
  }
  for (const char* units : {"0", "-1000", "1e-300"}) {
    EXPECT_THAT(error_with("mav0/depth0/sensor.yaml",
                           "depth_units_per_m:", "depth_units_per_m: " + std::string(units)),
                HasSubstr("depth0/sensor.yaml: camera: expected depth_units_per_m from 0.001"));
  }
}

TEST(Euroc, AStateWithoutARotationIsAnError) {
  const TempFolder folder;
  const auto path = folder.write("data.csv", "1,0,0,0,1e200,0,0,0,0,0,0,0,0,0,0,0,0\n");
  EXPECT_THAT(error_text([&] { vo::read_states(path); }),
              HasSubstr("data.csv:1: expected a quaternion of length 1"));
}

TEST(IclNuim, DistancesThatAreNoneAreErrors) {
  const TempFolder folder;
  folder.write("camera.toml", "width = 2\nheight = 1\nfx = 1.0\nfy = -1.0\ncx = 0.0\ncy = 0.0\n");
  const vo::RgbdFrame frame{0, cv::Mat(1, 2, CV_8UC3, cv::Scalar(1, 2, 3)),
                            vo::DepthImage(1, 2, 1.F)};
  vo::write_files(folder.path(), vo::encode_icl_nuim_frame({{2, 1, 1, 1, 0, 0, {}}}, 0, frame, {}));
  const auto source = vo::open_sequence(folder.path(), vo::SequenceFormat::icl_nuim);
  for (const char* text : {"1 nan", "1 inf", "-1 1", "1 1e300", "1", "1 2 3"}) {
    folder.write("scene_00_0000.depth", text);
    EXPECT_THAT(error_text([&] { source.read(0); }),
                HasSubstr("scene_00_0000.depth: expected 2 distances, got"))
        << text;
  }
}

TEST(IclNuim, MirroringIsItsOwnInverseAndMovesNoPixel) {
  const vo::RgbdCamera camera = example().camera;
  const vo::SE3 T_world_camera = support::example_pose(0.4);
  EXPECT_LT((vo::mirrored(vo::mirrored(T_world_camera)).inverse() * T_world_camera).log().norm(),
            1e-12);
  // The same point of the world, its z of the other sign, is seen in the same pixel.
  const Eigen::Vector3d p_camera(0.3, -0.2, 2);
  Eigen::Vector3d p_theirs = T_world_camera * p_camera;
  p_theirs.z() *= -1;
  const Eigen::Vector3d seen = vo::mirrored(T_world_camera).inverse() * p_theirs;
  EXPECT_LT((vo::mirrored(camera).pinhole.project(seen) - camera.pinhole.project(p_camera)).norm(),
            1e-12);
}

TEST(IclNuim, AsRenderedReadsBack) {
  const vo::SequenceSource source = example();
  const TempFolder folder;
  for (std::size_t i = 0; i < kFrames; ++i) {
    vo::write_files(folder.path(), vo::encode_icl_nuim_frame(source.camera, i, source.read(i),
                                                             source.truth[i].T_world_camera));
  }
  vo::write_files(folder.path(), vo::encode_icl_nuim_lists(source));
  EXPECT_EQ(vo::detect_format(folder.path()), vo::SequenceFormat::icl_nuim);
  expect_same(vo::open_sequence(folder.path(), vo::SequenceFormat::icl_nuim), source, 1e-6);
  EXPECT_THAT(vo::read_file(folder.path() / "camera.toml"), HasSubstr("fy = -5.5"));
}

TEST(IclNuim, DistanceIsAlongTheRay) {
  const TempFolder folder;
  folder.write("camera.toml", "width = 2\nheight = 1\nfx = 1.0\nfy = -1.0\ncx = 0.0\ncy = 0.0\n");
  folder.write("scene_00_0000.depth", "3 2.8284271247 ");
  folder.write(
      "scene_00_0000.txt",
      "cam_pos      = [1, 2, 3]';\ncam_dir      = [0, 0, 1]';\ncam_up       = [0, 1, 0]';\n");
  const vo::RgbdFrame frame{0, cv::Mat(1, 2, CV_8UC3, cv::Scalar(1, 2, 3)),
                            vo::DepthImage(1, 2, 1.F)};
  vo::write_files(folder.path(),
                  {vo::encode_icl_nuim_frame({{2, 1, 1, 1, 0, 0, {}}}, 0, frame, {})[0]});
  const auto source = vo::open_sequence(folder.path(), vo::SequenceFormat::icl_nuim);
  EXPECT_NEAR(source.read(0).depth(0, 0), 3, 1e-6);
  EXPECT_NEAR(source.read(0).depth(0, 1), 2, 1e-6) << "45 degrees off the axis";
  EXPECT_LT((source.truth[0].T_world_camera.translation() - Eigen::Vector3d(1, 2, -3)).norm(),
            1e-12);
  folder.write("scene_00_0000.depth", "3 x ");
  EXPECT_THAT(error_text([&] { source.read(0); }), HasSubstr("column 1, row 0"));
}

TEST(IclNuim, ErrorsOfAPoseEndWithItsLine) {
  const TempFolder folder;
  folder.write("scene_00_0000.png", "");
  const auto error_of = [&](const std::string& direction) {
    folder.write("scene_00_0000.txt",
                 "cam_pos = [1, 2, 3]';\ncam_dir = " + direction + "\ncam_up = [0, 1, 0]';\n");
    return error_text([&] { vo::open_sequence(folder.path(), vo::SequenceFormat::icl_nuim); });
  };
  const std::string place = (folder.path() / "scene_00_0000.txt").string();
  EXPECT_EQ(error_of("[0, 0,x]"),
            place + ": cam_dir: expected numbers with commas between, got '0, 0,x'");
  EXPECT_EQ(error_of("[0, 0,x"), place + ": expected cam_dir = [x, y, z]");
}

/// From a frame of the data set's trajectory at 200 frames a second: `right` is 4/3 long.
TEST(IclNuim, ReadsTheCameraAsPovRayWritesIt) {
  const TempFolder folder;
  folder.write("camera.toml", "width = 1\nheight = 1\nfx = 1.0\nfy = -1.0\ncx = 0.0\ncy = 0.0\n");
  folder.write("scene_00_0000.depth", "3 ");
  folder.write("scene_00_0000.txt",
               "cam_pos      = [149.376, 451.41, -285.9]';\n"
               "cam_dir      = [0.421738, -0.409407, 0.809026]';\n"
               "cam_up       = [-0.0482194, 0.880868, 0.470899]';\n"
               "cam_lookat   = [0, 0, 1]';\ncam_sky      = [0, 1, 0]';\n"
               "cam_right    = [1.20423, 0.316017, -0.467833]';\n"
               "cam_fpoint   = [0, 0, 10]';\ncam_angle    = 90;\n");
  const vo::RgbdFrame frame{0, cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)),
                            vo::DepthImage(1, 1, 1.F)};
  vo::write_files(folder.path(),
                  {vo::encode_icl_nuim_frame({{1, 1, 1, 1, 0, 0, {}}}, 0, frame, {})[0]});
  const auto source = vo::open_sequence(folder.path(), vo::SequenceFormat::icl_nuim);
  const vo::SE3 T_theirs = vo::mirrored(source.truth[0].T_world_camera);
  const Eigen::Vector3d right = Eigen::Vector3d(1.20423, 0.316017, -0.467833).normalized();
  EXPECT_LT((T_theirs.rotation_matrix().col(0) - right).norm(), 1e-5);
}

/// As the data set's getcamK finds K: f = pixels / |right| and pixels / |up| at |dir| = 1.
TEST(IclNuim, WritesTheFocalLengthsIntoTheCameraVectors) {
  const vo::SequenceSource source = example();
  const TempFolder folder;
  vo::write_files(folder.path(), vo::encode_icl_nuim_frame(source.camera, 0, source.read(0),
                                                           source.truth[0].T_world_camera));
  const std::string text = vo::read_file(folder.path() / "scene_00_0000.txt");
  const auto length = [&](const char* key) {
    const std::size_t begin = text.find('[', text.find(key)) + 1;
    const auto values = vo::parse_reals(text.substr(begin, text.find(']', begin) - begin), 3);
    return std::hypot(values[0], values[1], values[2]);
  };
  const vo::PinholeCamera& camera = source.camera.pinhole;
  EXPECT_NEAR(camera.width * length("cam_dir") / length("cam_right"), camera.fx, 1e-9);
  EXPECT_NEAR(camera.height * length("cam_dir") / length("cam_up"), camera.fy, 1e-9);
}

TEST(IclNuim, TumCompatibleReadsBack) {
  const vo::SequenceSource source = example();
  const TempFolder folder;
  for (std::size_t i = 0; i < kFrames; ++i) {
    vo::write_files(folder.path(), vo::encode_icl_tum_frame(source.camera, i, source.read(i)));
  }
  vo::write_files(folder.path(), vo::encode_icl_tum_lists(source));
  EXPECT_EQ(vo::detect_format(folder.path()), vo::SequenceFormat::icl_tum);
  expect_same(vo::open_sequence(folder.path(), vo::SequenceFormat::icl_tum), source,
              0.5 / 1000 + 1e-6);
}

TEST(Formats, WhatIsNoneIsToldByName) {
  const TempFolder folder;
  EXPECT_THAT(error_text([&] { vo::detect_format(folder.path()); }),
              HasSubstr("holds no sequence that is known"));
  EXPECT_THAT(error_text([&] { vo::detect_format(folder.path() / "none"); }),
              HasSubstr("there is no such folder"));
}

TEST(DepthUnits, DepthBeyond16BitIsNoneAndCounted) {
  vo::DepthImage depth(1, 4);
  depth << 0.0F, 13.1068F, 13.1072F, 20.0F;
  const auto units = vo::to_depth_units(depth, 5000);
  EXPECT_EQ(units(0, 1), 65534);
  EXPECT_EQ(units(0, 2), 0);
  EXPECT_EQ(units(0, 3), 0);
  EXPECT_EQ(vo::count_beyond_16_bit(depth, 5000), 2U);
}

}  // namespace
