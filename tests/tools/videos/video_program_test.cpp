#include <cstring>
#include <filesystem>
#include <string>

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/program_test.h"
#include "tests/support/same_pixels.h"
#include "tests/support/textured_plane.h"
#include "vo/dataset/colour_sequence.h"
#include "vo/dataset/sequence.h"
#include "vo/videos/video_sequence.h"

namespace {

namespace fs = std::filesystem;
using support::have_same_pixels;
using support::ProgramResult;
using support::run_program;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kFrames = 24;
constexpr double kRateHz = 25;  // of which stamps in lists are exact

/// Returns a shared library (ELF, 64 bits) whose segments ask for more memory than can be
/// addressed.
std::string of_vast_memory(std::string library) {
  constexpr Elf64_Xword kVast = Elf64_Xword{1} << 60U;  // bytes
  Elf64_Ehdr header{};
  std::memcpy(&header, library.data(), sizeof(header));
  for (std::size_t i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    char* const place = library.data() + header.e_phoff + i * sizeof(segment);
    std::memcpy(&segment, place, sizeof(segment));
    if (segment.p_type == PT_LOAD && (segment.p_flags & PF_W) != 0) {
      segment.p_memsz = kVast;
      std::memcpy(place, &segment, sizeof(segment));
    }
  }
  return library;
}

/// Runs the program on images of a plane in colour, the camera moving 1 cm to the right per frame,
/// and on a video of them.
class VideoProgram : public support::ProgramTest {
 protected:
  void SetUp() override {
#ifndef EDVO_HAS_VIDEO
    GTEST_SKIP() << "libopencv-videoio-dev was not found";
#else
    write_images();
    const ProgramResult result =
        run_program("convert " + path("images") + " " + path("video.avi") + " --format video");
    ASSERT_EQ(result.exit_code, 0) << result.err;
#endif
  }

  static vo::RgbdCamera camera() {
    return {vo::PinholeCamera::from_horizontal_fov(160, 120, 60)};
  }

  /// Tracks the video by a copy of the program in a folder, and writes its exit code and what it
  /// says of errors into `code` and `err`.
  void track_video_by_copy(const std::string& folder) const {
    fs::copy_file(EDVO_PROGRAM, file(folder + "/edvo"));
    const std::string arguments =
        "track " + path("video.avi") + with_camera() + " --mode mono --out " + path("v.txt");
    const ProgramResult result =
        run_program("--version", path(folder + "/edvo") + " " + arguments + " 2>" + path("err") +
                                     "; echo $? >" + path("code") + "; ");
    EXPECT_EQ(result.exit_code, 0);
  }

  void write_images() const {
    std::vector<double> stamps;
    for (std::size_t i = 0; i < kFrames; ++i) {
      stamps.push_back(static_cast<double>(i) / kRateHz);
      const vo::SE3 T_world_camera(Eigen::Quaterniond::Identity(),
                                   {0.01 * static_cast<double>(i), 0, 0});
      vo::RgbdFrame frame = support::TexturedPlane().render(camera().pinhole, T_world_camera);
      const std::vector<cv::Mat> channels = {frame.image / 2, frame.image, 255 - frame.image};
      cv::merge(channels, frame.image);
      vo::write_files(file("images"), vo::encode_colour_frame(i, frame),
                      {vo::ExistingOutput::keep, vo::Durability::unsynced});
    }
    vo::write_files(file("images"), vo::encode_colour_lists(camera(), stamps));
  }

  std::string with_camera() const {
    return " --camera " + path("images/camera.toml");
  }
};

TEST_F(VideoProgram, TheTrackOfALosslessVideoIsThatOfTheImagesToTheByte) {
  const ProgramResult images = run_program("track " + path("images") + " --mode mono --out " +
                                           path("images.txt") + " --json");
  const ProgramResult video = run_program("track " + path("video.avi") + with_camera() +
                                          " --mode mono --out " + path("video.txt") + " --json");
  EXPECT_EQ(images.exit_code, video.exit_code) << video.err;
  EXPECT_GT(read("images.txt").size(), 1000U);
  EXPECT_EQ(read("images.txt"), read("video.txt"));
  EXPECT_THAT(nlohmann::json::parse(video.out)["sequence_notes"],
              ElementsAre("the stamps are the container's times of presentation"));
}

TEST_F(VideoProgram, AVideoConvertedBackHasTheSamePixelsStampsAndVideo) {
  ASSERT_EQ(run_program("convert " + path("video.avi") + " " + path("back") + " --format tum" +
                        with_camera())
                .exit_code,
            0);
  EXPECT_FALSE(exists("back/depth.txt"));
  EXPECT_EQ(read("back/rgb.txt"), read("images/rgb.txt"));
  EXPECT_EQ(read("back/camera.toml"), read("images/camera.toml"));
  const vo::SequenceSource video = vo::open_video(file("video.avi"), camera());
  const vo::SequenceReader back(file("back"), std::nullopt, 0.02, vo::SequenceContent::colour);
  const vo::SequenceReader images(file("images"), std::nullopt, 0.02, vo::SequenceContent::colour);
  ASSERT_EQ(images.size(), kFrames);
  for (std::size_t i = 0; i < images.size(); ++i) {
    EXPECT_TRUE(have_same_pixels(video.read(i).image, images.read(i).image)) << i;
    EXPECT_TRUE(have_same_pixels(back.read(i).image, images.read(i).image)) << i;
  }
  ASSERT_EQ(run_program("convert " + path("back") + " " + path("again.avi") + " --format video")
                .exit_code,
            0);
  EXPECT_EQ(read("again.avi"), read("video.avi"));
}

TEST_F(VideoProgram, WhatAVideoDoesNotHoldIsNamed) {
  vo::write_files(file("images"), {{"groundtruth.txt", "0 0 0 0 0 0 0 1\n0.04 1 0 0 0 0 0 1\n"}});
  std::string list = read("images/rgb.txt");
  list.replace(list.find("0.040000"), 8, "0.047000");
  write("images/rgb.txt", list);
  const ProgramResult result =
      run_program("convert " + path("images") + " " + path("v.mp4") + " --format video --json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto summary = nlohmann::json::parse(result.out);
  EXPECT_THAT(summary["dropped"], ElementsAre("the frames' stamps", "the camera", "the 2 poses"));
  EXPECT_EQ(summary["frames"], kFrames);
  EXPECT_EQ(summary["poses"], 0);
}

TEST_F(VideoProgram, AVideoThereIsKeptOrReplacedAsAsked) {
  const std::string again =
      "convert " + path("video.avi") + with_camera() + " " + path("out.avi") + " --format video";
  write("out.avi", "other");
  EXPECT_EQ(run_program(again).exit_code, 6);
  EXPECT_EQ(read("out.avi"), "other");
  EXPECT_EQ(run_program(again + " --force").exit_code, 0);
  EXPECT_EQ(read("out.avi"), read("video.avi"));
  EXPECT_EQ(run_program(again).exit_code, 0) << "the same bytes";
  EXPECT_EQ(
      run_program("convert " + path("images") + " " + path("v.mkv") + " --format video").exit_code,
      2);
  EXPECT_FALSE(has_leftovers());
}

TEST_F(VideoProgram, AFullDiskIsSaidAndLeavesNothing) {
  for (const std::string name : {"full.avi", "full.mp4"}) {
    const ProgramResult result = run_program(
        "convert " + path("images") + " " + path(name) + " --format video", "ulimit -f 16; ");
    EXPECT_EQ(result.exit_code, 75) << name;
    EXPECT_THAT(result.err, HasSubstr(name + ": cannot be written"));
    EXPECT_FALSE(exists(name));
    EXPECT_FALSE(has_leftovers());
  }
}

TEST_F(VideoProgram, AVideoIsNoRgbdSequence) {
  const ProgramResult result =
      run_program("track " + path("video.avi") + with_camera() + " --out " + path("v.txt"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("video.avi: its frames have no depth, expected some or --mode "
                                    "mono"));
  const ProgramResult images = run_program("track " + path("images") + " --out " + path("v.txt"));
  EXPECT_EQ(images.exit_code, 3);
  EXPECT_THAT(images.err, HasSubstr("images: has no depth.txt, expected one or --mode mono"));
}

TEST_F(VideoProgram, EvaluationCountsTheFramesOfAVideo) {
  write("truth.txt", "0 0 0 0 0 0 0 1\n0.04 1 0 0 0 0 0 1\n0.08 2 0 1 0 0 0 1\n");
  const ProgramResult result =
      run_program("evaluate " + path("truth.txt") + " " + path("truth.txt") +
                  " --align none --json --sequence " + path("video.avi"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["tracked_fraction"], 3.0 / kFrames);
}

TEST_F(VideoProgram, WithoutTheLibraryTheErrorNamesIt) {
  fs::create_directory(file("alone"));
  track_video_by_copy("alone");
  EXPECT_EQ(read("code"), "3\n");
  EXPECT_THAT(read("err"), HasSubstr("video.avi: this program was built without OpenCV's videoio, "
                                     "expected libedvo_video.so of a build with "
                                     "libopencv-videoio-dev"));
}

TEST_F(VideoProgram, ALibraryThatIsNoneIsUnusableAndOneWithoutRoomInMemoryIsTemporary) {
  write("junk/libedvo_video.so", "junk");
  track_video_by_copy("junk");
  EXPECT_EQ(read("code"), "3\n") << read("err");
  write("vast/libedvo_video.so",
        of_vast_memory(vo::read_file(fs::path(EDVO_PROGRAM).parent_path() / "libedvo_video.so")));
  track_video_by_copy("vast");
  EXPECT_EQ(read("code"), "75\n") << read("err");
  EXPECT_THAT(read("err"), HasSubstr("video.avi: OpenCV's videoio cannot be loaded"));
}

}  // namespace
