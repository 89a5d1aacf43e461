#include "vo/exports/convert_sequence.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/example_trajectory.h"
#include "tests/support/sequence_layouts.h"
#include "tests/support/temp_folder.h"
#include "vo/core/fields.h"
#include "vo/dataset/camera_file.h"
#include "vo/dataset/sequence.h"
#include "vo/files/input.h"
#include "vo/motion_files/imu_file.h"
#include "vo/motion_files/trajectory_file.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::array kOthers = {vo::WrittenSequence::tartanair, vo::WrittenSequence::kitti,
                                vo::WrittenSequence::colmap, vo::WrittenSequence::transforms_json};

/// Writes the textured plane of four frames as TUM's layout.
vo::SequenceSource write_plane(const std::filesystem::path& folder) {
  const vo::SequenceSource source = support::rendered_sequence(4);
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    vo::write_files(folder, vo::encode_frame({source.camera}, i, source.read(i)));
  }
  vo::write_files(folder, vo::encode_lists({source.camera}, source.truth));
  return source;
}

/// The plane in TUM's layout, in a folder of its own.
class ConvertSequence : public testing::Test {
 protected:
  ConvertSequence() : source(write_plane(in)) {}

  vo::ConvertOutcome convert(vo::WrittenSequence to) const {
    return vo::convert_sequence({.in = in, .out = out(to), .to = to}, {}, [](auto, auto) {});
  }

  void name_world() const { folder.write("in/world.toml", "up = \"y\"\n"); }

  void set_camera(const vo::RgbdCamera& camera) const {
    folder.write("in/camera.toml", vo::format_camera(camera));
  }

  std::filesystem::path out(vo::WrittenSequence to) const {
    return folder.path() / std::string(vo::to_string(to));
  }

  /// The error of a conversion, which must leave nothing.
  std::string error(vo::WrittenSequence to) const {
    const std::string text = error_text([&] { convert(to); });
    EXPECT_FALSE(std::filesystem::exists(out(to)));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
      EXPECT_EQ(entry.path().filename(), "in") << "is left over";
    }
    return text;
  }

  TempFolder folder;
  std::filesystem::path in = folder.path() / "in";
  vo::SequenceSource source;
};

TEST_F(ConvertSequence, TartanAirIsReadBackWithItsPosesAndDepth) {
  const vo::ConvertOutcome outcome = convert(vo::WrittenSequence::tartanair);
  EXPECT_EQ(outcome.frames, 4U);
  EXPECT_THAT(outcome.dropped, ElementsAre("the frames' stamps"));
  const auto copy = vo::open_sequence(out(vo::WrittenSequence::tartanair),
                                      vo::detect_format(out(vo::WrittenSequence::tartanair)));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(
        (copy.truth[i].T_world_camera.inverse() * source.truth[i].T_world_camera).log().norm(),
        1e-8);
    EXPECT_EQ(cv::norm(copy.read(i).image, source.read(i).image, cv::NORM_INF), 0);
    EXPECT_LT(cv::norm(copy.read(i).depth, source.read(i).depth, cv::NORM_INF), 0.0006) << "m";
  }
}

TEST_F(ConvertSequence, ImagesWithoutDepthAreWrittenAndReadBackAsAFolderWithoutDepth) {
  std::filesystem::remove(in / "depth.txt");
  std::filesystem::remove_all(in / "depth");
  EXPECT_THAT(convert(vo::WrittenSequence::tum).dropped, IsEmpty());
  const std::filesystem::path copied = out(vo::WrittenSequence::tum);
  EXPECT_FALSE(std::filesystem::exists(copied / "depth.txt"));
  EXPECT_FALSE(std::filesystem::exists(copied / "depth"));
  EXPECT_EQ(vo::read_file(copied / "rgb.txt"), vo::read_file(in / "rgb.txt"));
  const vo::SequenceSource copy = vo::open_sequence(copied, vo::SequenceFormat::tum);
  ASSERT_EQ(copy.timestamps.size(), source.timestamps.size());
  for (std::size_t i = 0; i < copy.timestamps.size(); ++i) {
    EXPECT_EQ(cv::norm(copy.read(i).image, source.read(i).image, cv::NORM_INF), 0);
    EXPECT_TRUE(copy.read(i).depth.empty());
  }
  EXPECT_THAT(error_text([&] { const vo::SequenceReader reader(copied); }),
              testing::EndsWith("has no depth.txt, expected one or --mode mono"));
}

TEST_F(ConvertSequence, FramesWithoutAPoseAreLeftOutAndCounted) {
  name_world();
  vo::Trajectory late(source.truth.begin() + 1, source.truth.end());
  folder.write("in/groundtruth.txt", vo::format_trajectory(late));
  for (const vo::WrittenSequence to : kOthers) {
    const vo::ConvertOutcome outcome = convert(to);
    EXPECT_EQ(outcome.frames, 3U) << vo::to_string(to);
    EXPECT_THAT(outcome.notes, ElementsAre("1 of 4 frames have no pose and are left out"));
  }
}

TEST_F(ConvertSequence, WithoutPosesThoseWhichNeedThemAreErrorsAndTheOthersHaveNone) {
  std::filesystem::remove(in / "groundtruth.txt");
  for (const auto to : {vo::WrittenSequence::colmap, vo::WrittenSequence::transforms_json}) {
    EXPECT_THAT(error(to), HasSubstr("none of its frames has a pose, which "));
  }
  EXPECT_EQ(convert(vo::WrittenSequence::kitti).frames, 4U);
  EXPECT_FALSE(std::filesystem::exists(out(vo::WrittenSequence::kitti) / "poses"));
  EXPECT_EQ(convert(vo::WrittenSequence::tartanair).frames, 4U);
  EXPECT_FALSE(std::filesystem::exists(out(vo::WrittenSequence::tartanair) / "pose_left.txt"));
}

TEST_F(ConvertSequence, ACameraWithYUpIsAnError) {
  vo::RgbdCamera camera = source.camera;
  camera.pinhole.fy = -camera.pinhole.fy;
  set_camera(camera);
  for (const vo::WrittenSequence to : kOthers) {
    EXPECT_THAT(error(to), HasSubstr("in: its camera has y up, fy = -")) << vo::to_string(to);
  }
}

TEST_F(ConvertSequence, ALensIsTakenOutWhereTheFormatHasNone) {
  name_world();
  vo::RgbdCamera camera = source.camera;
  camera.pinhole.distortion = {-0.1, 0.02, 0.001, 0.001, 0.01};
  camera.readout.seconds = 0.02;
  set_camera(camera);
  EXPECT_THAT(convert(vo::WrittenSequence::kitti).dropped,
              ElementsAre("depth", "the rolling shutter's read-out time"));
  for (const auto to : {vo::WrittenSequence::kitti, vo::WrittenSequence::euroc,
                        vo::WrittenSequence::icl_tum, vo::WrittenSequence::tartanair}) {
    std::filesystem::remove_all(out(to));
    EXPECT_THAT(convert(to).notes, ElementsAre(HasSubstr("images are undistorted, ")))
        << vo::to_string(to);
  }
  EXPECT_THAT(convert(vo::WrittenSequence::colmap).notes, IsEmpty());
  EXPECT_THAT(convert(vo::WrittenSequence::transforms_json).notes, IsEmpty());
  const auto euroc =
      vo::open_sequence(out(vo::WrittenSequence::euroc), vo::SequenceFormat::euroc).camera.pinhole;
  EXPECT_TRUE(euroc.distortion.is_zero());
}

TEST_F(ConvertSequence, ALensWithADenominatorStaysWhereTheFormatHasIt) {
  name_world();
  vo::RgbdCamera camera = source.camera;
  camera.pinhole.distortion = {-0.1, 0.02, 0.001, 0.001, 0.01, 0.05, 0.002, 0.001};
  set_camera(camera);
  EXPECT_THAT(convert(vo::WrittenSequence::colmap).notes, IsEmpty());
  EXPECT_THAT(vo::read_file(out(vo::WrittenSequence::colmap) / "sparse/0/cameras.txt"),
              HasSubstr(" -0.1 0.02 0.001 0.001 0.01 0.05 0.002 0.001\n"));
  EXPECT_THAT(convert(vo::WrittenSequence::transforms_json).notes,
              ElementsAre(HasSubstr("images are undistorted, ")));
}

/// A world with y up, an IMU at rest in it, and float depth.
TEST_F(ConvertSequence, EurocsWorldHasZUpAndGravityStaysWhereItWas) {
  name_world();
  vo::SequenceSource with_imu = source;
  const vo::SE3 T_world_body = support::example_pose(0.7);
  const Eigen::Vector3d upwards = T_world_body.inverse() * Eigen::Vector3d(0, 9.81, 0) -
                                  T_world_body.inverse() * Eigen::Vector3d::Zero();
  folder.write("in/imu.csv", vo::format_imu({{0, {0, 0, 0}, upwards}}));
  folder.write("in/truth/imu_states.csv",
               vo::format_states({{0, T_world_body, {1, 2, 3}, {0, 0, 0}, {0, 0, 0}}}));
  const vo::ConvertOutcome outcome = convert(vo::WrittenSequence::euroc);
  EXPECT_EQ(outcome.up, vo::WorldUp::z);
  const auto euroc = vo::open_sequence(out(vo::WrittenSequence::euroc), vo::SequenceFormat::euroc);
  EXPECT_EQ(euroc.up, vo::WorldUp::z);
  ASSERT_EQ(euroc.imu.states.size(), 1U);
  const vo::BodyState& state = euroc.imu.states[0];
  const Eigen::Vector3d force = state.T_world_body.rotation() * euroc.imu.samples[0].specific_force;
  EXPECT_LT((force - Eigen::Vector3d(0, 0, 9.81)).norm(), 1e-8) << "m/s^2";
  EXPECT_LT((state.velocity - Eigen::Vector3d(1, -3, 2)).norm(), 1e-8) << "m/s";
  const Eigen::Vector3d& p = T_world_body.translation();
  EXPECT_LT((state.T_world_body.translation() - Eigen::Vector3d(p.x(), -p.z(), p.y())).norm(),
            1e-8);
}

TEST_F(ConvertSequence, AWorldOfWhichNothingIsKnownStaysAndANoteSaysSo) {
  EXPECT_THAT(convert(vo::WrittenSequence::euroc).notes,
              ElementsAre(HasSubstr("which axis of its world points up is not known")));
}

TEST_F(ConvertSequence, AWorldThatIsChosenIsWrittenDownAndComesBack) {
  name_world();
  const auto job = [&](const char* from, const char* to, vo::WrittenSequence format,
                       vo::WorldUp up) {
    return vo::convert_sequence(
        {.in = folder.path() / from, .out = folder.path() / to, .to = format, .up = up}, {},
        [](auto, auto) {});
  };
  job("in", "a", vo::WrittenSequence::euroc, vo::WorldUp::y);
  EXPECT_EQ(vo::open_sequence(folder.path() / "a", vo::SequenceFormat::euroc).up, vo::WorldUp::y);
  job("a", "b", vo::WrittenSequence::tum, vo::WorldUp::z);
  EXPECT_EQ(vo::open_sequence(folder.path() / "b", vo::SequenceFormat::tum).up, vo::WorldUp::z);
  job("b", "c", vo::WrittenSequence::tartanair, vo::WorldUp::unknown);
  job("c", "d", vo::WrittenSequence::tum, vo::WorldUp::y);
  const vo::Trajectory poses = vo::read_trajectory(folder.path() / "d/groundtruth.txt");
  ASSERT_EQ(poses.size(), source.truth.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((poses[i].T_world_camera.inverse() * source.truth[i].T_world_camera).log().norm(),
              1e-8);
  }
  EXPECT_THAT(error_text([&] { job("in", "e", vo::WrittenSequence::kitti, vo::WorldUp::z); }),
              HasSubstr("--world: kitti has a world of its own"));
  folder.write("in/world.toml", "up = \"x\"\n");
  EXPECT_THAT(error_text([&] { convert(vo::WrittenSequence::euroc); }), HasSubstr("world.toml"));
}

TEST_F(ConvertSequence, FloatDepthAndTruthAreCarriedWhereTheFormatHoldsThem) {
  vo::SequenceLayout layout{.camera = source.camera, .float_depth = vo::FloatDepth::npy};
  for (std::size_t i = 0; i < 4; ++i) {
    vo::write_files(in, vo::encode_frame(layout, i, source.read(i)), vo::ExistingOutput::replace);
    folder.write("in/truth/moving/" + vo::frame_number(i) + ".png", "moving " + std::to_string(i));
    folder.write("in/truth/normal/" + vo::frame_number(i) + ".npy", "normal");
  }
  vo::write_files(in, vo::encode_lists(layout, source.truth), vo::ExistingOutput::replace);
  name_world();
  for (const auto to :
       {vo::WrittenSequence::tum, vo::WrittenSequence::tartanair, vo::WrittenSequence::icl_nuim}) {
    convert(to);
    const auto copy = vo::open_sequence(out(to), vo::detect_format(out(to)));
    EXPECT_TRUE(copy.has_float_depth);
    EXPECT_LT(cv::norm(copy.read(2).depth, source.read(2).depth, cv::NORM_INF), 1e-6)
        << vo::to_string(to);
  }
  EXPECT_EQ(vo::read_file(out(vo::WrittenSequence::tum) / "truth/moving/000003.png"), "moving 3");
  EXPECT_TRUE(std::filesystem::exists(out(vo::WrittenSequence::tum) / "truth/normal/000000.npy"));
  EXPECT_THAT(convert(vo::WrittenSequence::euroc).dropped,
              ElementsAre("what depth has beyond 16 bit", "truth/moving", "truth/normal"));
  std::filesystem::remove_all(out(vo::WrittenSequence::tum));
  const vo::ConvertOutcome turned =
      vo::convert_sequence({.in = in, .out = out(vo::WrittenSequence::tum), .up = vo::WorldUp::z},
                           {}, [](auto, auto) {});
  EXPECT_THAT(turned.dropped, ElementsAre("truth/normal"));
}

TEST_F(ConvertSequence, StampsOfDepthAreCarriedWhereTheFormatHoldsThem) {
  const std::array delays = {-0.008, 0.0, 0.004, -0.016};  // s
  std::vector<double> depth_stamps = source.timestamps;
  for (std::size_t i = 0; i < delays.size(); ++i) {
    depth_stamps[i] += delays.at(i);
  }
  vo::write_files(in, vo::encode_image_lists({source.camera}, source.timestamps, depth_stamps),
                  vo::ExistingOutput::replace);
  for (const auto to :
       {vo::WrittenSequence::tum, vo::WrittenSequence::euroc, vo::WrittenSequence::mcap}) {
    EXPECT_THAT(convert(to).dropped, testing::Not(testing::Contains("the stamps of depth")));
    const auto copy = vo::open_sequence(out(to), vo::detect_format(out(to)));
    for (std::size_t i = 0; i < delays.size(); ++i) {
      EXPECT_NEAR(copy.read(i).depth_delay, delays.at(i), 1e-6) << vo::to_string(to) << i;
    }
  }
  EXPECT_THAT(convert(vo::WrittenSequence::transforms_json).dropped,
              testing::Contains("the stamps of depth"));
}

TEST_F(ConvertSequence, StampsThatNanosecondsDoNotTellApartAreRefused) {
  const std::vector<double> stamps = {1, 1.0000000001, 2, 3};
  vo::write_files(in, vo::encode_image_lists({source.camera}, stamps, stamps),
                  vo::ExistingOutput::replace);
  for (const auto to : {vo::WrittenSequence::euroc, vo::WrittenSequence::mcap}) {
    EXPECT_THAT(error(to), HasSubstr("in: frames 0 and 1 lie within a nanosecond"));
  }
}

TEST_F(ConvertSequence, AColmapModelIsReadAsATrajectoryByTheNamesOfItsImages) {
  convert(vo::WrittenSequence::colmap);
  const vo::Trajectory poses =
      vo::read_trajectory(out(vo::WrittenSequence::colmap) / "sparse/0/images.txt");
  ASSERT_EQ(poses.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(poses[i].timestamp, source.timestamps[i], 1e-6);
    EXPECT_LT((poses[i].T_world_camera.inverse() * source.truth[i].T_world_camera).log().norm(),
              1e-8);
  }
}

}  // namespace
