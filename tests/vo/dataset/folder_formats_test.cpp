#include <array>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/support/error_text.h"
#include "tests/support/pose_near.h"
#include "tests/support/sequence_layouts.h"
#include "tests/support/temp_folder.h"
#include "vo/core/fields.h"
#include "vo/dataset/open3d.h"
#include "vo/dataset/scannet.h"
#include "vo/dataset/sequence.h"
#include "vo/dataset/seven_scenes.h"
#include "vo/dataset/tartanair.h"
#include "vo/image_files/jpeg_codec.h"
#include "vo/image_files/pnm.h"

namespace {

namespace fs = std::filesystem;
using support::error_text;
using support::ImageFormat;
using support::PoseNear;
using support::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using vo::SequenceFormat;

constexpr int kLayoutFrames = 4;
constexpr support::PoseTolerance kRounding{.translation_m = 1e-9, .rotation_deg = 1e-6};
constexpr double kHalfMillimetre = 0.5e-3 + 1e-6;  // m, rounding of depth
constexpr double kAsStored = 0;

/// A layout: how it is written, and what of a frame it keeps.
struct Layout {
  SequenceFormat format;
  void (*write)(const fs::path& folder, const vo::SequenceSource& source,
                const ImageFormat& images);
  double rate;         ///< frames per second that are assumed
  double depth_error;  ///< m
};

const std::vector<Layout>& layouts() {
  static const std::vector<Layout> all = {
      {SequenceFormat::seven_scenes, support::write_seven_scenes, 30, kHalfMillimetre},
      {SequenceFormat::scannet, support::write_scannet, 30, kHalfMillimetre},
      {SequenceFormat::open3d, support::write_open3d, 30, kHalfMillimetre},
      {SequenceFormat::tartanair, support::write_tartanair, 10, kAsStored}};
  return all;
}

ImageFormat pixel_maps() {
  return {".ppm", vo::encode_pnm};
}

ImageFormat jpegs() {
  return {".jpg", [](const cv::Mat& image) {
            const auto bytes = vo::encode_jpeg(image, 100, vo::ChromaSampling::full);
            return std::string(bytes.begin(), bytes.end());
          }};
}

class FolderFormats : public testing::TestWithParam<Layout> {
 protected:
  TempFolder folder;
  vo::SequenceSource source = support::rendered_sequence(kLayoutFrames);
};

std::string layout_name(const testing::TestParamInfo<Layout>& layout) {
  std::string name(vo::to_string(layout.param.format));
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Layouts, FolderFormats, testing::ValuesIn(layouts()), layout_name);

TEST_P(FolderFormats, OneSequenceReadsAlike) {
  GetParam().write(folder.path(), source, support::png_images());
  EXPECT_EQ(vo::detect_format(folder.path()), GetParam().format);
  const auto copy = vo::open_sequence(folder.path(), GetParam().format);
  EXPECT_THAT(copy.notes, IsEmpty());
  EXPECT_EQ(vo::format_camera(copy.camera), vo::format_camera(source.camera));
  ASSERT_EQ(copy.timestamps.size(), source.timestamps.size());
  ASSERT_EQ(copy.truth.size(), source.truth.size());
  for (std::size_t i = 0; i < source.timestamps.size(); ++i) {
    EXPECT_NEAR(copy.timestamps[i], static_cast<double>(i) / GetParam().rate, 1e-12);
    EXPECT_EQ(copy.truth[i].timestamp, copy.timestamps[i]);
    EXPECT_THAT(copy.truth[i].T_world_camera, PoseNear(source.truth[i].T_world_camera, kRounding));
    const vo::RgbdFrame frame = copy.read(i);
    EXPECT_EQ(frame.timestamp, copy.timestamps[i]);
    EXPECT_EQ(cv::norm(frame.image, source.read(i).image, cv::NORM_INF), 0);
    EXPECT_LE(cv::norm(frame.depth, source.read(i).depth, cv::NORM_INF), GetParam().depth_error);
  }
}

TEST_P(FolderFormats, ImagesMayBeJpegsOrPixelMaps) {
  constexpr double kJpegError = 6;  // grey values, of quality 100
  for (const auto& [images, error] : {std::pair{jpegs(), kJpegError}, {pixel_maps(), kAsStored}}) {
    const fs::path place = folder.path() / images.ending;
    GetParam().write(place, source, images);
    const vo::SequenceReader reader(place);
    ASSERT_EQ(reader.size(), source.timestamps.size());
    EXPECT_LE(cv::norm(reader.read(1).image, source.read(1).image, cv::NORM_INF), error);
  }
}

TEST_P(FolderFormats, ReadsWithoutTruth) {
  GetParam().write(folder.path(), source, support::png_images());
  for (const char* name : {"pose", "trajectory.log", "pose_left.txt"}) {
    fs::remove_all(folder.path() / name);
  }
  for (int i = 0; i < kLayoutFrames; ++i) {
    fs::remove(folder.path() / ("frame-00000" + std::to_string(i) + ".pose.txt"));
  }
  const auto copy = vo::open_sequence(folder.path(), vo::detect_format(folder.path()));
  EXPECT_THAT(copy.truth, IsEmpty());
  EXPECT_EQ(copy.timestamps.size(), source.timestamps.size());
}

TEST_P(FolderFormats, ALinkThatLeadsOutIsAnError) {
  const TempFolder outside;
  outside.write("secret.png", "x");
  GetParam().write(folder.path(), source, support::png_images());
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    if (entry.path().filename().string().find("000002") != std::string::npos ||
        entry.path().filename() == "2.png") {
      fs::remove(entry.path());
      fs::create_symlink(outside.path() / "secret.png", entry.path());
      break;
    }
  }
  EXPECT_THAT(error_text([&] { vo::SequenceReader(folder.path()).read(2); }),
              HasSubstr("leads by a symbolic link out of"));
}

TEST_P(FolderFormats, AnImageOfAnotherSizeIsNamed) {
  GetParam().write(folder.path(), source, support::png_images());
  vo::RgbdCamera camera = source.camera;
  camera.pinhole.width = 162;
  const auto copy = vo::open_sequence(folder.path(), GetParam().format, camera);
  EXPECT_THAT(error_text([&] { copy.read(0); }), HasSubstr("expected the camera's 162x120"));
}

TEST(SevenScenes, FramesWithoutAPoseAreNotInTheTruth) {
  const TempFolder folder;
  const vo::SequenceSource source = support::rendered_sequence(3);
  support::write_seven_scenes(folder.path(), source);
  fs::remove(folder.path() / "frame-000001.pose.txt");
  const auto copy = vo::open_seven_scenes(folder.path(), {});
  ASSERT_EQ(copy.truth.size(), 2U);
  EXPECT_EQ(copy.truth[1].timestamp, copy.timestamps[2]);
}

TEST(SevenScenes, HasThePresetsCameraWithoutAFile) {
  const TempFolder folder;
  support::write_seven_scenes(folder.path(), support::rendered_sequence(1));
  fs::remove(folder.path() / "camera.toml");
  EXPECT_EQ(vo::open_seven_scenes(folder.path(), {}).camera.pinhole.fx, 585);
}

TEST(SevenScenes, ErrorsNameTheFile) {
  const TempFolder folder;
  support::write_seven_scenes(folder.path(), support::rendered_sequence(3));
  const auto error = [&] { return error_text([&] { vo::open_seven_scenes(folder.path(), {}); }); };
  folder.write("frame-000001.pose.txt", "1 0 0 0\n0 1 0 0\n");
  EXPECT_THAT(error(),
              HasSubstr("frame-000001.pose.txt: expected four rows of four numbers, got 2"));
  folder.write("frame-000001.pose.txt", "1 0 0 0\n0 1 0\n");
  EXPECT_THAT(error(), HasSubstr("frame-000001.pose.txt:2: expected four rows of four numbers"));
  folder.write("frame-000001.pose.txt", "1 0 0 0\n0 2 0 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(error(), HasSubstr("frame-000001.pose.txt: expected a rotation"));
  folder.write("frame-000001.pose.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  fs::remove(folder.path() / "frame-000002.depth.png");
  EXPECT_THAT(error(), HasSubstr("frame-000002.color.png: has no depth"));
}

TEST(Scannet, LostFramesHaveNoPose) {
  const TempFolder folder;
  const vo::SequenceSource source = support::rendered_sequence(3);
  support::write_scannet(folder.path(), source);
  folder.write("pose/1.txt",
               "-inf -inf -inf -inf\n-inf -inf -inf -inf\n-inf -inf -inf -inf\n"
               "-inf -inf -inf -inf\n");
  const auto copy = vo::open_scannet(folder.path(), {});
  ASSERT_EQ(copy.truth.size(), 2U);
  EXPECT_EQ(copy.truth[1].timestamp, copy.timestamps[2]);
}

TEST(Scannet, FramesAreInTheOrderOfTheirNumbers) {
  const TempFolder folder;
  support::write_scannet(folder.path(), support::rendered_sequence(12));
  const auto copy = vo::open_scannet(folder.path(), {});
  ASSERT_EQ(copy.timestamps.size(), 12U);
  EXPECT_NEAR(copy.truth[10].timestamp, 10 / 30.0, 1e-12) << "10 comes after 9, not after 1";
  EXPECT_THAT(copy.truth[10].T_world_camera, PoseNear(support::sway(10), kRounding));
}

/// The colour camera has twice the pixels and another focal length and centre. The oracle is what
/// the depth camera renders; blurring by the smaller image is all that may differ.
TEST(Scannet, ColourOfAnotherSizeIsBroughtIntoTheDepthCamera) {
  const TempFolder folder;
  const vo::SequenceSource source = support::rendered_sequence(2);
  support::write_scannet(folder.path(), source);
  const vo::PinholeCamera& depth = source.camera.pinhole;
  const vo::PinholeCamera color{320, 240, 1.9 * depth.fx, 1.9 * depth.fy, 163, 117};
  folder.write("intrinsic/intrinsic_color.txt", support::camera_rows(color));
  for (int i = 0; i < 2; ++i) {
    folder.write(vo::concat("color/", i, ".png"),
                 vo::encode_png(support::sway_frame(color, i).image));
  }
  const auto copy = vo::open_scannet(folder.path(), {});
  EXPECT_EQ(vo::format_camera(copy.camera), vo::format_camera(source.camera));
  const cv::Mat expected = support::sway_frame(depth, 1).image;
  const cv::Rect inside(12, 10, 136, 100);  // the colour camera sees less
  const auto mean_difference = [&](const cv::Mat& image) {
    return cv::norm(image(inside), expected(inside), cv::NORM_L1) / inside.area();
  };
  cv::Mat resized;
  cv::resize(support::sway_frame(color, 1).image, resized, expected.size(), 0, 0, cv::INTER_AREA);
  EXPECT_LT(mean_difference(copy.read(1).image), 4) << "grey values";
  EXPECT_GT(mean_difference(resized), 10) << "the cameras do differ";
}

TEST(Scannet, ExtrinsicsThatAreNotAppliedAreANote) {
  const TempFolder folder;
  support::write_scannet(folder.path(), support::rendered_sequence(1));
  folder.write("intrinsic/extrinsic_color.txt", "1 0 0 -0.04\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(vo::open_scannet(folder.path(), {}).notes,
              ElementsAre(HasSubstr("extrinsic_color.txt: is not the identity")));
}

TEST(Open3d, RedwoodsNamesHaveStampsByWhichImagesAndDepthArePaired) {
  const TempFolder folder;
  const vo::SequenceSource source = support::rendered_sequence(3);
  const std::array<const char*, 3> colors = {"0000001-000000010000", "0000002-000000043000",
                                             "0000003-000000077000"};
  const std::array<const char*, 2> depths = {"0000001-000000041000", "0000002-000000200000"};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    folder.write(vo::concat("rgb/", colors.at(i), ".png"), vo::encode_png(source.read(i).image));
  }
  for (std::size_t i = 0; i < depths.size(); ++i) {
    folder.write(vo::concat("depth/", depths.at(i), ".png"),
                 support::depth_in_millimetres(source.read(i).depth));
  }
  folder.write("camera.toml", vo::format_camera(source.camera));
  const auto copy = vo::open_open3d(folder.path(), {});
  ASSERT_EQ(copy.timestamps.size(), 1U);
  EXPECT_NEAR(copy.timestamps[0], 0.043, 1e-12);
  EXPECT_EQ(cv::norm(copy.read(0).image, source.read(1).image, cv::NORM_INF), 0);
}

TEST(Open3d, WithoutIntrinsicsPrimeSensesAreUsedAndSaidSo) {
  const TempFolder folder;
  support::write_open3d(folder.path(), support::rendered_sequence(1));
  fs::remove(folder.path() / "camera_intrinsic.json");
  const auto copy = vo::open_open3d(folder.path(), {});
  EXPECT_EQ(copy.camera.pinhole.fx, 525);
  EXPECT_THAT(copy.notes, ElementsAre(HasSubstr("PrimeSense's defaults are used")));
}

TEST(Open3d, TheDepthScaleOfTheIntrinsicsCounts) {
  const TempFolder folder;
  support::write_open3d(folder.path(), support::rendered_sequence(1));
  folder.write("camera_intrinsic.json",
               "{\"width\": 160, \"height\": 120, \"depth_scale\": 4000.0,"
               " \"intrinsic_matrix\": [138.5, 0, 0, 0, 138.5, 0, 79.5, 59.5, 1]}");
  EXPECT_EQ(vo::open_open3d(folder.path(), {}).camera.depth_units_per_m, 4000);
}

TEST(Open3d, ErrorsNameTheFile) {
  const TempFolder folder;
  support::write_open3d(folder.path(), support::rendered_sequence(3));
  const auto error = [&] { return error_text([&] { vo::open_open3d(folder.path(), {}); }); };
  const std::string rows = support::matrix_rows(Eigen::Matrix4d::Identity());
  folder.write("trajectory.log", "0 0 1\n1 0 0 0\n");
  EXPECT_THAT(error(), HasSubstr("trajectory.log: ends within a pose's matrix"));
  folder.write("trajectory.log", "3 3 4\n" + rows);
  EXPECT_THAT(error(), HasSubstr("trajectory.log:1: expected one of 3 frames, from 0, got 3"));
  folder.write("trajectory.log", "1 1 2\n" + rows + "1 1 2\n" + rows);
  EXPECT_THAT(error(), HasSubstr("trajectory.log:6: expected a frame after the one before it"));
  folder.write("trajectory.log", "0 0 1\n" + rows);
  folder.write("other.log", "0 0 1\n" + rows);
  EXPECT_THAT(error(), HasSubstr("expected one trajectory, got other.log and trajectory.log"));
  fs::remove(folder.path() / "other.log");
  folder.write("camera_intrinsic.json", "{\"width\": 160, \"height\": 120}");
  EXPECT_THAT(error(), HasSubstr("camera_intrinsic.json: expected intrinsic_matrix"));
  folder.write("camera_intrinsic.json",
               "{\"width\": 1.5, \"height\": 120, \"intrinsic_matrix\": "
               "[1, 0, 0, 0, 1, 0, 0, 0, 1]}");
  EXPECT_THAT(error(), HasSubstr("camera_intrinsic.json: width: expected a whole number"));
  fs::remove(folder.path() / "depth/000001.png");
  EXPECT_THAT(error(), HasSubstr("has 3 images and 2 of depth"));
  folder.write("depth/cover.png", "");
  EXPECT_THAT(error(), HasSubstr("cover.png: expected a name that ends with a number"));
}

TEST(TartanAir, ItsAxesBecomeRightDownForward) {
  const TempFolder folder;
  support::write_tartanair(folder.path(), support::rendered_sequence(2));
  folder.write("pose_left.txt", "1 2 3 0 0 0 1\n0 0 0 0 0 0.70710678118 0.70710678118\n");
  const auto copy = vo::open_tartanair(folder.path(), {});
  const Eigen::Vector3d& t = copy.truth[0].T_world_camera.translation();
  EXPECT_LT((t - Eigen::Vector3d(2, 3, 1)).norm(), 1e-12) << "1 forward, 2 right, 3 down";
  const Eigen::Vector3d p_world = copy.truth[1].T_world_camera * Eigen::Vector3d(0, 0, 1);
  EXPECT_LT((p_world - Eigen::Vector3d(1, 0, 0)).norm(), 1e-9)
      << "a quarter turn about the vertical: what was right is ahead";
}

TEST(TartanAir, ErrorsNameTheFile) {
  const TempFolder folder;
  support::write_tartanair(folder.path(), support::rendered_sequence(2));
  const auto error = [&] { return error_text([&] { vo::open_tartanair(folder.path(), {}); }); };
  folder.write("pose_left.txt", "1 2 3 0 0 0 1\n");
  EXPECT_THAT(error(), HasSubstr("pose_left.txt: holds 1 poses, expected as many as there are "
                                 "images, 2"));
  folder.write("pose_left.txt", "1 2 3 0 0 0 1\n1 2 3 0 0 0\n");
  EXPECT_THAT(error(), HasSubstr("pose_left.txt:2: expected 7 values"));
}

TEST(TartanAir, DepthThatIsNoneIsNoMeasurement) {
  const TempFolder folder;
  support::write_tartanair(folder.path(), support::rendered_sequence(1));
  vo::DepthImage depth(120, 160, 2.0F);
  depth(0, 0) = std::numeric_limits<float>::infinity();
  depth(0, 1) = -1;
  depth(0, 2) = std::numeric_limits<float>::quiet_NaN();
  folder.write("depth_left/000000_left_depth.npy", vo::encode_npy(depth));
  const vo::RgbdFrame frame = vo::open_tartanair(folder.path(), {}).read(0);
  EXPECT_EQ(cv::countNonZero(frame.depth), 120 * 160 - 3);
}

TEST(KnownFormat, IsNoneOfAnotherFolder) {
  const TempFolder folder;
  folder.write("readme.txt", "x");
  EXPECT_FALSE(vo::known_format(folder.path()).has_value());
  EXPECT_THAT(error_text([&] { vo::detect_format(folder.path()); }),
              HasSubstr("frame-000000.color.png (7-Scenes)"));
}

}  // namespace
